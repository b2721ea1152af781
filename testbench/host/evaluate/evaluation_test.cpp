// Spec section 12: precision and recall by hand.
#include "sailmap/evaluation.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "host/map_builders.hpp"
#include "sailmap/error.hpp"

namespace sailmap {
namespace {

using ::testing::DoubleNear;

constexpr float none = not_admissible;

Plane<float> matrix(const std::vector<std::vector<float>>& rows) {
  Plane<float> out(static_cast<int>(rows.front().size()), static_cast<int>(rows.size()));
  for (int y = 0; y < out.height(); ++y) {
    for (int x = 0; x < out.width(); ++x)
      out(x, y) = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
  }
  return out;
}

// Five queries over four candidates: right at 9, wrong at 8, right at 7, no loop at 6, and one that cannot
// match.
struct Worked {
  Plane<float> scores =
      matrix({{9, 1, 1, none}, {2, 8, 3, 1}, {0, 7, 1, 2}, {6, 5, 4, 3}, {none, none, none, none}});
  GroundTruth truth{{{0}, {2}, {1, 3}, {}, {0}}};
};

TEST(Evaluation, CountsQueriesByAdmissibility) {
  const Worked w;
  const Evaluation e = evaluate(w.scores, w.truth, 5);
  EXPECT_EQ(e.queries, 4);
  EXPECT_EQ(e.queries_with_match, 3);
}

TEST(Evaluation, TheCurveFallsThroughTheScores) {
  const Worked w;
  const Evaluation e = evaluate(w.scores, w.truth, 5);
  ASSERT_EQ(e.curve.size(), 4U);
  const double expected[4][3] = {
      {9, 1, 1.0 / 3}, {8, 1.0 / 2, 1.0 / 3}, {7, 2.0 / 3, 2.0 / 3}, {6, 2.0 / 4, 2.0 / 3}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_DOUBLE_EQ(e.curve[i].threshold, expected[i][0]);
    EXPECT_DOUBLE_EQ(e.curve[i].precision, expected[i][1]);
    EXPECT_DOUBLE_EQ(e.curve[i].recall, expected[i][2]);
  }
  EXPECT_DOUBLE_EQ(e.average_precision, 1.0 / 3 + (1.0 / 3) * (2.0 / 3));
  EXPECT_DOUBLE_EQ(e.recall_at_100, 1.0 / 3);
  EXPECT_DOUBLE_EQ(e.recall_at_95, 1.0 / 3);
  EXPECT_DOUBLE_EQ(e.best_f1, 2.0 / 3);
  EXPECT_DOUBLE_EQ(e.best_f1_threshold, 7);
}

TEST(Evaluation, RanksOfTheBestTrueMatch) {
  const Worked w;
  // Query 0: rank 1; query 1: candidate 2 (score 3) behind 8: rank 2; query 2: rank 1.
  const Evaluation e = evaluate(w.scores, w.truth, 5);
  EXPECT_DOUBLE_EQ(e.recall_at[0], 2.0 / 3);
  EXPECT_DOUBLE_EQ(e.recall_at[1], 1);
  EXPECT_DOUBLE_EQ(e.recall_at[2], 1);
}

TEST(Evaluation, TheFixedThresholdIsStrict) {
  const Worked w;
  const FixedThreshold f = evaluate(w.scores, w.truth, 7).fixed;
  EXPECT_EQ(f.detections, 2);
  EXPECT_EQ(f.right, 1);
  EXPECT_DOUBLE_EQ(f.precision, 0.5);
  EXPECT_DOUBLE_EQ(f.recall, 1.0 / 3);
  const FixedThreshold nothing = evaluate(w.scores, w.truth, 100).fixed;
  EXPECT_EQ(nothing.detections, 0);
  EXPECT_DOUBLE_EQ(nothing.precision, 1);
  EXPECT_DOUBLE_EQ(nothing.recall, 0);
}

TEST(Evaluation, EqualScoresEnterTogether) {
  const Evaluation e = evaluate(matrix({{5, 1}, {5, 1}, {3, 1}}), {{{0}, {1}, {0}}}, 0);
  ASSERT_EQ(e.curve.size(), 2U);
  EXPECT_DOUBLE_EQ(e.curve[0].precision, 0.5);
  EXPECT_DOUBLE_EQ(e.average_precision, 1.0 / 3 * 0.5 + 1.0 / 3 * 2.0 / 3);
  EXPECT_DOUBLE_EQ(e.recall_at_100, 0);
}

TEST(Evaluation, RecallAt95TakesTheDeepestSuchPoint) {
  // 20 right, then one wrong (20/21 = 0.952), then one right (21/22), then wrong (21/23 = 0.913).
  std::vector<std::vector<float>> rows;
  GroundTruth truth;
  for (int q = 0; q < 23; ++q) {
    rows.push_back({static_cast<float>(100 - q), 0});
    const bool wrong = q == 20 || q == 22;
    truth.matches.push_back({wrong ? 1 : 0});
  }
  const Evaluation e = evaluate(matrix(rows), truth, 0);
  EXPECT_THAT(e.recall_at_100, DoubleNear(20.0 / 23, 1e-12));
  EXPECT_THAT(e.recall_at_95, DoubleNear(21.0 / 23, 1e-12));
}

TEST(Evaluation, RefusesWhatCannotBeMeasured) {
  EXPECT_THROW(evaluate(matrix({{1, 2}}), {{{0}, {1}}}, 0), Error);
  EXPECT_THROW(evaluate(matrix({{1, 2}}), {{{}}}, 0), Error);
  EXPECT_THROW(evaluate(matrix({{1, none}}), {{{1}}}, 0), Error);
}

TEST(Scores, SequenceExcludesTheRecentAndTheFuture) {
  std::vector<Signature> images;
  for (const int place : {0, 1, 0, 1, 2}) images.push_back(testing::image_of_place(place));
  const Plane<float> scores = score_sequence(images, 1, {});
  ASSERT_EQ(scores.width(), 5);
  ASSERT_EQ(scores.height(), 5);
  for (int q = 0; q < 5; ++q) {
    for (int c = 0; c < 5; ++c) {
      EXPECT_EQ(std::isnan(scores(c, q)), c >= q - 1) << q << ' ' << c;
      if (c < q - 1) {
        EXPECT_FLOAT_EQ(scores(c, q), static_cast<float>(match(images[static_cast<std::size_t>(q)],
                                                               images[static_cast<std::size_t>(c)], {})
                                                             .similarity));
      }
    }
  }
  EXPECT_FLOAT_EQ(scores(0, 2), 1e6F);
  EXPECT_LT(scores(0, 3), 100);
  EXPECT_THROW(score_sequence(images, -1, {}), Error);
}

TEST(Scores, TraversesAreComparedWhole) {
  const std::vector<Signature> queries = {testing::image_of_place(4), testing::image_of_place(0)};
  const std::vector<Signature> references = {testing::image_of_place(0), testing::image_of_place(2),
                                             testing::image_of_place(4)};
  const Plane<float> scores = score_traverses(queries, references, {});
  ASSERT_EQ(scores.width(), 3);
  ASSERT_EQ(scores.height(), 2);
  EXPECT_FLOAT_EQ(scores(2, 0), 1e6F);
  EXPECT_FLOAT_EQ(scores(0, 1), 1e6F);
  for (const float score : scores.samples()) EXPECT_FALSE(std::isnan(score));
}

}  // namespace
}  // namespace sailmap
