// What the method context promises: the same place scores high though moved, turned, grey or smaller; others
// low.
#include "sailmap/context.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "sailmap/detection.hpp"
#include "sailmap/evaluation.hpp"
#include "synthetic_maps.hpp"

namespace sailmap {
namespace {

using testing::scene_maps;

constexpr unsigned places = 24;

std::vector<PlaceDescriptor> many_places() {
  std::vector<PlaceDescriptor> out;
  for (unsigned place = 0; place < places; ++place) out.push_back(describe_place(scene_maps(place)));
  return out;
}

std::vector<float> scores(const Maps& query, const std::vector<PlaceDescriptor>& candidates) {
  std::vector<const PlaceDescriptor*> pointers;
  for (const PlaceDescriptor& candidate : candidates) pointers.push_back(&candidate);
  return score_contexts(describe_place(query), pointers);
}

void expect_recognised(const Maps& query, std::size_t place, const std::vector<PlaceDescriptor>& candidates) {
  const std::vector<float> result = scores(query, candidates);
  for (std::size_t c = 0; c < result.size(); ++c) {
    if (c == place) {
      EXPECT_GT(result[c], default_threshold(Method::context)) << c;
    } else {
      EXPECT_LT(result[c], default_threshold(Method::context)) << c;
    }
  }
}

TEST(Context, TheSameImageScoresNearlyOne) {
  const auto candidates = many_places();
  for (unsigned place = 0; place < places; ++place) {
    EXPECT_GT(scores(scene_maps(place), candidates)[place], 0.98F);
    EXPECT_NEAR(match_contexts(candidates[place], candidates[place]).similarity, 1, 1e-5);
    EXPECT_EQ(layout_agreement(candidates[place].layout, candidates[place].layout), 1);
  }
}

TEST(Context, APlaceIsRecognisedThoughShiftedTurnedOrSmaller) {
  const auto candidates = many_places();
  expect_recognised(scene_maps(4, 16), 4, candidates);
  expect_recognised(scene_maps(5, -16), 5, candidates);
  expect_recognised(scene_maps(6, 0, 8), 6, candidates);
  expect_recognised(scene_maps(7, 0, -8), 7, candidates);
  expect_recognised(scene_maps(8, 0, 0, feature_count, 40, 30), 8, candidates);
}

// What is as good as the best is no rival where it shows the same place: a robot goes its round every day.
TEST(Context, APlaceIsRecognisedThoughTheMapHasItFromTwelveLaps) {
  const int laps = 12;
  const unsigned round = 8;
  std::vector<PlaceDescriptor> candidates;
  for (int lap = 0; lap < laps; ++lap) {
    for (unsigned place = 0; place < round; ++place) {
      candidates.push_back(describe_place(scene_maps(place, 2 * lap - laps)));
    }
  }
  for (unsigned place = 0; place < round; ++place) {
    const std::vector<float> result = scores(scene_maps(place, 1), candidates);
    const auto best = std::max_element(result.begin(), result.end());
    EXPECT_EQ(static_cast<unsigned>(best - result.begin()) % round, place);
    EXPECT_GT(*best, default_threshold(Method::context)) << place;
  }
}

TEST(Context, AllMatchedRegionsOfAShiftAreDisplacedByIt) {
  const PlaceDescriptor query = describe_place(scene_maps(2));
  const PlaceDescriptor moved = describe_place(scene_maps(2, 12));
  const MatchResult result = match_contexts(query, moved);
  ASSERT_GT(result.matches.size(), 20U);
  int exact = 0;
  for (const RegionMatch& match : result.matches) {
    const auto& from = query.regions[static_cast<std::size_t>(match.query)];
    const auto& to = moved.regions[static_cast<std::size_t>(match.candidate)];
    if (std::abs((to.x - from.x) / 65535.0 - 12.0 / 160) < 0.01 && std::abs(to.y - from.y) / 65535.0 < 0.01)
      ++exact;
  }
  EXPECT_GT(exact, static_cast<int>(result.matches.size()) * 3 / 4);
}

TEST(Context, GreyImagesAreRecognisedAmongGreyOnes) {
  // Intensity alone: the two maps that come first.
  std::vector<PlaceDescriptor> candidates;
  for (unsigned place = 0; place < places; ++place)
    candidates.push_back(describe_place(scene_maps(place, 0, 0, 2)));
  expect_recognised(scene_maps(3, 5, 0, 2), 3, candidates);
}

// The same regions, since the saliency is left as it was.
TEST(Context, ColoursThatAGreyImageLacksDoNotCountAgainstIt) {
  const PlaceDescriptor coloured = describe_place(scene_maps(3));
  Maps maps = scene_maps(3);
  for (std::size_t i = 2; i < 6; ++i) maps.features[i].samples = Plane<double>(160, 120, 0.0);
  const PlaceDescriptor grey = describe_place(maps);
  EXPECT_NEAR(match_contexts(grey, coloured).similarity, 1, 1e-5);
  EXPECT_NEAR(match_contexts(coloured, grey).similarity, 1, 1e-5);
  // Other maps do count.
  maps = scene_maps(3);
  for (std::size_t i = 0; i < 2; ++i) maps.features[i].samples = Plane<double>(160, 120, 0.0);
  EXPECT_LT(match_contexts(describe_place(maps), coloured).similarity, 0.9);
}

TEST(Context, FlatImagesScoreZero) {
  auto candidates = many_places();
  const PlaceDescriptor flat;
  std::vector<const PlaceDescriptor*> pointers;
  for (const PlaceDescriptor& candidate : candidates) pointers.push_back(&candidate);
  for (const float score : score_contexts(flat, pointers)) EXPECT_EQ(score, 0);
  candidates[0] = flat;
  EXPECT_EQ(scores(scene_maps(0), candidates)[0], 0);
  EXPECT_EQ(match_contexts(flat, flat).similarity, 0);
  EXPECT_TRUE(score_contexts(candidates[1], {}).empty());
}

// Swapping the images swaps the pairs; only ties among equal agreements may fall otherwise.
TEST(Context, MatchingIsSymmetricWithinOnePercent) {
  const auto candidates = many_places();
  for (std::size_t a = 0; a < 6; ++a) {
    for (std::size_t b = 0; b < 6; ++b) {
      EXPECT_NEAR(match_contexts(candidates[a], candidates[b]).similarity,
                  match_contexts(candidates[b], candidates[a]).similarity, 0.01);
    }
  }
}

TEST(Context, OnlyTheFortyBestLayoutsAreScored) {
  std::vector<PlaceDescriptor> candidates;
  for (unsigned place = 0; place < 60; ++place) candidates.push_back(describe_place(scene_maps(place)));
  const std::vector<float> result = scores(scene_maps(50), candidates);
  EXPECT_LE(std::count_if(result.begin(), result.end(), [](float s) { return s > 0; }), 40);
  EXPECT_GT(result[50], 0.98F);
}

// Signs instead of the cells' values: the agreement of two contexts follows the correlation of the values
// they were taken from (for Gaussian values it would be asin(r) * 2 / pi).
TEST(Context, BitsKeepTheOrderOfRealCorrelations) {
  const PlaceDescriptor still = describe_place(scene_maps(11));
  double before = 1;
  for (const double shift : {2.0, 6.0, 12.0, 24.0}) {
    const double agreement = layout_agreement(still.layout, describe_place(scene_maps(11, 0, shift)).layout);
    EXPECT_LT(agreement, before) << shift;
    before = agreement;
  }
}

TEST(Context, ThreadsDoNotMatter) {
  std::vector<Signature> images;
  for (unsigned i = 0; i < 30; ++i) {
    Signature signature{640, 480, {}};
    signature.place = describe_place(scene_maps(i % 12, i > 12 ? 4 : 0));
    images.push_back(signature);
  }
  MatchConfig config;
  config.method = Method::context;
  const Plane<float> all = score_sequence(images, 5, config);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Plane<float> alone = score_sequence(images, 5, config);
  for (std::size_t i = 0; i < all.samples().size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint32_t>(all.samples()[i]),
              std::bit_cast<std::uint32_t>(alone.samples()[i]));
  }
  EXPECT_GT(alone(2, 14), 0.3F);
  EXPECT_TRUE(std::isnan(alone(10, 14)));
}

}  // namespace
}  // namespace sailmap
