// The filter on score matrices made by hand: what it lifts, what it leaves, and that it never looks ahead.
#include "sailmap/temporal_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "sailmap/error.hpp"
#include "sailmap/evaluation.hpp"

namespace sailmap {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

// `queries` images, each with `candidates`; the true one of query q, if any, is truth(q). Noise below 0.3;
// true matches 0.25 .. 0.9 when strong, 0.15 .. 0.6 when weak: many of those lose against the noise.
struct Sequence {
  Plane<float> scores;
  GroundTruth truth;
};

Sequence sequence(int queries, int candidates, unsigned seed, const std::function<int(int)>& truth,
                  bool weak) {
  std::mt19937 random(seed);
  const auto part = [&random] { return static_cast<float>(random() >> 8) / 16777216.0F; };
  Sequence out{Plane<float>(candidates, queries), {}};
  for (int q = 0; q < queries; ++q) {
    out.truth.matches.emplace_back();
    for (int c = 0; c < candidates; ++c) {
      const float noise = part();
      out.scores(c, q) = 0.3F * noise * noise;
    }
    if (const int match = truth(q); match >= 0 && match < candidates) {
      out.truth.matches.back() = {match};
      out.scores(match, q) = weak ? 0.15F + 0.45F * part() : 0.25F + 0.65F * part();
    }
  }
  return out;
}

double precision(const Plane<float>& scores, const GroundTruth& truth) {
  return evaluate(scores, truth, 0.3).average_precision;
}

double rise(const Sequence& s, int images = 10) {
  return precision(filter_scores(s.scores, {images, none}), s.truth) - precision(s.scores, s.truth);
}

TEST(TemporalFilter, LiftsRouteRepeatsInEitherDirectionAndAtAnySpeed) {
  EXPECT_GT(rise(sequence(
                150, 200, 1, [](int q) { return q - 20; }, true)),
            0.02);
  EXPECT_GT(rise(sequence(
                150, 200, 2, [](int q) { return 180 - q; }, true)),
            0.02);
  EXPECT_GT(rise(sequence(
                90, 200, 3, [](int q) { return 2 * q + 3; }, true)),
            0.02);
  EXPECT_GT(rise(sequence(
                150, 200, 4, [](int q) { return 10 + q / 2; }, true)),
            0.02);
}

TEST(TemporalFilter, HarmsRevisitsWithoutOrderByNoMoreThanAHundredth) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    // No image says anything about the next.
    const auto jump = [seed](int q) { return q % 3 == 0 ? -1 : static_cast<int>((q * 7919U + seed) % 200U); };
    EXPECT_GE(rise(sequence(150, 200, seed, jump, false)), -0.01) << seed;
    EXPECT_GE(rise(sequence(150, 200, seed, jump, true)), -0.01) << seed;
  }
}

TEST(TemporalFilter, HarmsShortPiecesAndDroppedImagesByNoMoreThanAHundredth) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    // Three images of the route, then somewhere else; every second time in reverse.
    const auto piece = [seed](int q) {
      const int start = static_cast<int>((static_cast<unsigned>(q / 3) * 7919U + seed) % 170U);
      return q / 3 % 2 == 0 ? start + q % 3 : start + 3 - q % 3;
    };
    EXPECT_GE(rise(sequence(150, 200, seed, piece, false)), -0.01) << seed;
    // The map moves on by 1 to 5 candidates.
    const auto dropped = [seed](int q) {
      return 3 * q + static_cast<int>((static_cast<unsigned>(q) * 7919U + seed) % 3U);
    };
    EXPECT_GE(rise(sequence(65, 200, seed, dropped, false)), -0.01) << seed;
  }
}

TEST(TemporalFilter, ImagesThatAreDoubledBringNothingNew) {
  const Sequence s = sequence(
      60, 60, 11, [](int q) { return q; }, true);
  Plane<float> twice(60, 120);
  for (int q = 0; q < 120; ++q) {
    for (int c = 0; c < 60; ++c) twice(c, q) = s.scores(c, q / 2);
  }
  const Plane<float> once = filter_scores(s.scores, {10, none});
  const Plane<float> out = filter_scores(twice, {10, none});
  for (int q = 0; q < 120; ++q) {
    for (int c = 0; c < 60; ++c) ASSERT_EQ(out(c, q), once(c, q / 2));
  }
}

TEST(TemporalFilter, IsOffForNoneOrOneImage) {
  const Sequence s = sequence(
      20, 20, 1, [](int q) { return q; }, true);
  for (const int images : {0, 1})
    EXPECT_EQ(filter_scores(s.scores, {images, none}).samples()[37], s.scores.samples()[37]);
}

TEST(TemporalFilter, LooksAtThePastOnly) {
  const Sequence s = sequence(
      60, 60, 6, [](int q) { return q; }, true);
  Plane<float> other = s.scores;
  for (int q = 40; q < 60; ++q) {
    for (int c = 0; c < 60; ++c) other(c, q) = 0.5F;
  }
  const Plane<float> a = filter_scores(s.scores, {10, none});
  const Plane<float> b = filter_scores(other, {10, none});
  for (int q = 0; q < 40; ++q) {
    for (int c = 0; c < 60; ++c) ASSERT_EQ(a(c, q), b(c, q));
  }
}

TEST(TemporalFilter, WhatIsNotAdmissibleStaysSoAndCarriesNothing) {
  Sequence s = sequence(
      40, 40, 7, [](int q) { return q - 10; }, false);
  for (int q = 0; q < 40; ++q) {
    for (int c = std::max(0, q - 5); c < 40; ++c) s.scores(c, q) = not_admissible;
  }
  const Plane<float> out = filter_scores(s.scores, {10, none});
  for (int q = 0; q < 40; ++q) {
    for (int c = 0; c < 40; ++c) EXPECT_EQ(std::isnan(out(c, q)), std::isnan(s.scores(c, q)));
  }
}

TEST(TemporalFilter, ScoresStayWithinTheirRangeAndKeepTheirScale) {
  const Sequence s = sequence(
      80, 80, 8, [](int q) { return q; }, false);
  const Plane<float> out = filter_scores(s.scores, {10, none});
  for (const float score : out.samples()) {
    EXPECT_GE(score, 0);
    EXPECT_LE(score, 1);
  }
  // A method of another scale: the same scores, expanded by s / (1 - s) * 3.
  Plane<float> wide = s.scores;
  for (float& score : wide.samples()) score = 3 * score / (1 - score);
  const Plane<float> wide_out = filter_scores(wide, {10, 3});
  for (std::size_t i = 0; i < out.samples().size(); ++i) {
    const float expected = 3 * out.samples()[i] / (1 - out.samples()[i]);
    EXPECT_NEAR(wide_out.samples()[i], expected, 1e-3F * (1 + expected));
  }
}

TEST(TemporalFilter, AnOutlierOfAnUnboundedMethodDoesNotDrownASequence) {
  Sequence s = sequence(
      100, 100, 9, [](int q) { return q; }, false);
  for (float& score : s.scores.samples()) score = 3 * score / (1 - score);
  s.scores(3, 50) = 1e6F;
  const Plane<float> out = filter_scores(s.scores, temporal_config(Method::paper_weighted, 10));
  for (int q = 55; q < 100; ++q) EXPECT_GT(out(q, q), out(std::min(99, q - 47), q));
}

TEST(TemporalFilter, TrustsSequencesOnlyWhereTheyForetell) {
  TemporalFilter repeated({10, none});
  TemporalFilter jumping({10, none});
  const Sequence a = sequence(
      60, 60, 10, [](int q) { return q; }, false);
  const Sequence b = sequence(
      60, 60, 10, [](int q) { return q * 37 % 60; }, false);
  for (std::size_t q = 0; q < 60; ++q) {
    repeated.apply(a.scores.samples().subspan(q * 60, 60));
    jumping.apply(b.scores.samples().subspan(q * 60, 60));
  }
  EXPECT_GT(repeated.trust(), 0.9);
  EXPECT_EQ(jumping.trust(), 0);
}

// A route along the candidates, 0.5 the true one's score, until image `odd`, whose scores the test gives.
std::vector<float> after_a_route(int odd, const std::function<float(int)>& score, double telling_odds = 0.5) {
  TemporalFilter filter({10, none, 0.5, telling_odds});
  std::vector<float> row(60, 0.01F);
  for (int q = 0; q < odd; ++q) {
    std::fill(row.begin(), row.end(), 0.01F);
    row[static_cast<std::size_t>(q)] = 0.5F;
    filter.apply(row);
  }
  for (int c = 0; c < 60; ++c) row[static_cast<std::size_t>(c)] = score(c);
  return filter.apply(row);
}

int place_of(const std::vector<float>& scores) {
  return static_cast<int>(std::max_element(scores.begin(), scores.end()) - scores.begin());
}

TEST(TemporalFilter, ASureImageKeepsItsChoiceAndAnUnsureOneDoesNot) {
  const auto shows = [](float elsewhere, float ahead) {
    return [=](int c) { return c == 5 ? elsewhere : (c == 40 ? ahead : 0.01F); };
  };
  EXPECT_EQ(place_of(after_a_route(40, shows(0.55F, 0.54F))), 5);   // odds 1.22 and 1.17
  EXPECT_EQ(place_of(after_a_route(40, shows(0.48F, 0.40F))), 40);  // below odds of 1
  // Images that do not tell places apart are sure where they show another clearly less.
  EXPECT_EQ(place_of(after_a_route(40, shows(0.55F, 0.49F), none)), 5);  // odds 1.22 and 0.96
  EXPECT_EQ(place_of(after_a_route(40, shows(0.55F, 0.52F), none)), 40);
}

TEST(TemporalFilter, ARouteLeadsNowhereThatTheImageAllButExcludes) {
  const auto shows = [](float ahead) {
    return [=](int c) { return c == 5 ? 0.02F : (c >= 30 ? ahead : 1e-5F); };
  };
  EXPECT_GE(place_of(after_a_route(40, shows(1e-4F))), 30);
  EXPECT_EQ(place_of(after_a_route(40, shows(1e-5F))), 5);
}

TEST(TemporalFilter, WhatIsLeftOfARouteThatEndedLeadsNowhere) {
  TemporalFilter filter({10, none, 0.5, 0.5});
  std::vector<float> row(60);
  const auto shows = [&](int place, float score) {
    std::fill(row.begin(), row.end(), 1e-5F);
    row[static_cast<std::size_t>(place)] = score;
    return filter.apply(row);
  };
  for (int q = 0; q < 60; ++q) shows(q, 0.5F);
  for (int after = 0; after < 4; ++after) EXPECT_EQ(place_of(shows(5 + after, 0.008F)), 5 + after);
}

TEST(TemporalFilter, ImagesOfNoPlaceInTheMapArePutNowhere) {
  // A route along the map, and then somewhere else: images that show next to nothing, but that in the order
  // of a part of the map.
  TemporalFilter filter({10, none, 0.3, 0.5});
  std::vector<float> row(60);
  const auto shows = [&](int place, float score) {
    for (int c = 0; c < 60; ++c) row[static_cast<std::size_t>(c)] = c == place ? score : 1e-4F;
    return filter.apply(row);
  };
  for (int q = 0; q < 60; ++q) shows(q, 0.8F);
  for (int q = 0; q < 5; ++q) {
    const std::vector<float> scores = shows(10 + q, 0.03F);
    EXPECT_LT(*std::max_element(scores.begin(), scores.end()), 0.2F) << q;
  }
}

TEST(TemporalFilter, APlaceThatImagesHardlyShowIsPutForwardAmidARouteAlone) {
  const auto blank = [](int /*c*/) { return 0.01F; };
  EXPECT_GT(after_a_route(40, blank)[40], 0.2F);
  const auto last = [](int c) { return c == 59 ? 0.1F : 0.01F; };
  EXPECT_LT(after_a_route(60, last)[59], 0.2F);
}

TEST(TemporalFilter, AnImageThatTellsPlacesApartChoosesAmongNeighbours) {
  // The route goes on at 40; 39 and 41 show a little more or less than it.
  const auto shows = [](float best) {
    return [=](int c) { return c == 41 ? best : (c == 40 ? 0.95F * best : 0.01F); };
  };
  EXPECT_EQ(place_of(after_a_route(40, shows(0.45F))), 41);
  EXPECT_EQ(place_of(after_a_route(40, shows(0.25F))), 40);
}

TEST(TemporalFilter, WrongConfigurationsAreRefused) {
  EXPECT_THROW(TemporalFilter({-1, none}), Error);
  EXPECT_THROW(TemporalFilter({1001, none}), Error);
  EXPECT_THROW(TemporalFilter({10, 0}), Error);
  EXPECT_THROW(TemporalFilter({10, std::nan("")}), Error);
  EXPECT_THROW(TemporalFilter({10, none, -0.1}), Error);
  EXPECT_THROW(TemporalFilter({10, none, 1.1}), Error);
  EXPECT_THROW(TemporalFilter({10, none, std::nan("")}), Error);
  EXPECT_THROW(TemporalFilter({10, none, 0.5, 0}), Error);
  EXPECT_THROW(TemporalFilter({10, none, 0.5, std::nan("")}), Error);
}

TEST(TemporalFilter, ThePowerSaysHowMuchTheForecastCounts) {
  const Sequence route = sequence(
      150, 200, 1, [](int q) { return q - 20; }, true);
  double last = 0;
  for (const double power : {0.1, 0.3, 0.5}) {
    const Plane<float> out = filter_scores(route.scores, {10, none, power});
    double lift = 0;
    for (int q = 70; q < out.height(); ++q) lift += out(q - 20, q);
    EXPECT_GT(lift, last) << power;
    last = lift;
  }
}

}  // namespace
}  // namespace sailmap
