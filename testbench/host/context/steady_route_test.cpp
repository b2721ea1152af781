// Sequences whose single images are weak, made by hand: where the route may lead, and where it may not.
#include "sailmap/steady_route.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "sailmap/evaluation.hpp"
#include "sailmap/temporal_filter.hpp"

namespace sailmap {
namespace {

constexpr int candidates = 200;

struct Sequence {
  Plane<float> scores;
  GroundTruth truth;
};

// Image q is at candidate place(q), which is true with its neighbours. A part of the images, `shows`, show
// it, by `score` and a bit; all show some other places, by up to 0.3.
Sequence sequence(unsigned seed, const std::function<int(int)>& place, double shows, float score = 0.2F,
                  int queries = 180) {
  std::mt19937 random(seed);
  const auto part = [&random] { return static_cast<float>(random() >> 8) / 16777216.0F; };
  Sequence out{Plane<float>(candidates, queries), {}};
  std::fill(out.scores.samples().begin(), out.scores.samples().end(), 0.0F);
  for (int q = 0; q < queries; ++q) {
    for (int k = 0; k < 8; ++k) out.scores(static_cast<int>(random() % candidates), q) = 0.3F * part();
    if (part() < static_cast<float>(shows)) out.scores(place(q), q) = score + 0.1F * part();
    out.truth.matches.push_back({place(q) - 1, place(q), place(q) + 1});
  }
  return out;
}

double precision(const Plane<float>& scores, const GroundTruth& truth) {
  return evaluate(scores, truth, 0.2).average_precision;
}

Plane<float> filtered(const Sequence& s) {
  return filter_scores(s.scores, temporal_config(Method::context, 10));
}

// Of the last image.
double belief(const Sequence& s) {
  ScoreEvidence evidence(std::numeric_limits<double>::infinity());
  RouteModel usual(10);
  SteadyRoute steady(10);
  for (int q = 0; q < s.scores.height(); ++q) {
    const auto row =
        evidence.read(s.scores.samples().subspan(static_cast<std::size_t>(q) * candidates, candidates));
    const std::vector<float> likelihoods = evidence.likelihoods(row);
    const double expected = usual.advance(likelihoods, row.count, 0).expected;
    const std::vector<float> odds = steady.advance(row, likelihoods, 0, expected);
    EXPECT_EQ(odds.size(), static_cast<std::size_t>(candidates));
    EXPECT_TRUE(std::all_of(odds.begin(), odds.end(), [](float v) { return v >= 0 && v < 20; }));
  }
  return steady.belief();
}

int onwards(int q) { return q + 10; }
int backwards(int q) { return 190 - q; }
int anywhere(int q) { return 1 + static_cast<int>(static_cast<unsigned>(q) * 73U % (candidates - 2)); }
int pieces_of_three(int q) { return 1 + anywhere(q / 3) / 3 * 3 % 190 + q % 3; }

TEST(SteadyRoute, LeadsWhereMostImagesShowAnotherPlace) {
  for (const auto& way : {onwards, backwards}) {
    const Sequence s = sequence(1, way, 0.6);
    EXPECT_LT(precision(s.scores, s.truth), 0.15);
    EXPECT_GT(precision(filtered(s), s.truth), 0.6);
    EXPECT_GT(belief(s), 0.5);
  }
}

TEST(SteadyRoute, PutsForwardWhatAnImageDoesNotShowAtAll) {
  const Sequence s = sequence(2, onwards, 0.6);
  const Plane<float> out = filtered(s);
  int hidden = 0;
  int led = 0;
  for (int q = 100; q < 180; ++q) {
    const int place = onwards(q);
    if (s.scores(place, q) > 0) continue;
    ++hidden;
    bool best = true;
    for (int c = 0; c < candidates; ++c) {
      best = best && (std::abs(c - place) <= 2 || out(c, q) < out(place, q));
    }
    led += best ? 1 : 0;
  }
  EXPECT_GT(hidden, 20);
  EXPECT_GT(led, hidden / 2);
}

TEST(SteadyRoute, SaysNothingWhereImagesAreRight) { EXPECT_EQ(belief(sequence(3, onwards, 1, 0.4F)), 0); }

TEST(SteadyRoute, SaysNothingOfImagesInNoOrder) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Sequence s = sequence(seed, anywhere, 0.6);
    EXPECT_LT(belief(s), 0.01);
    EXPECT_NEAR(precision(filtered(s), s.truth), precision(s.scores, s.truth), 0.01);
    EXPECT_LT(belief(sequence(seed, pieces_of_three, 0.6)), 0.01);
  }
}

TEST(SteadyRoute, ASureImageIsNotOverruled) {
  Sequence s = sequence(4, onwards, 0.4);
  for (int q = 90; q < 180; q += 9) s.scores(3, q) = 0.6F;
  const Plane<float> out = filtered(s);
  for (int q = 90; q < 180; q += 9) {
    for (int c = 0; c < candidates; ++c) EXPECT_LE(out(c, q), out(3, q));
  }
}

}  // namespace
}  // namespace sailmap
