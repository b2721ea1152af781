// Differences between front ends, by hand.
#include "sailmap/comparison.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "host/map_builders.hpp"
#include "sailmap/error.hpp"

namespace sailmap {
namespace {

// Maps of 40 x 40 that are 1 everywhere, with saliency peaks at the given places.
Maps maps_with_peaks(const std::vector<std::pair<int, int>>& peaks) {
  Maps maps;
  maps.image_width = 160;
  maps.image_height = 160;
  for (std::size_t i = 0; i < map_count; ++i) map_at(maps, i).samples = Plane<double>(40, 40, 1);
  maps.feature_statistics.fill({1, 3});
  Plane<double> saliency(40, 40);
  double height = 9;
  for (const auto& [x, y] : peaks) saliency(x, y) = height--;
  maps.saliency.samples = saliency;
  return maps;
}

TEST(Comparison, ErrorsInUnitsAndShares) {
  const Maps expected = maps_with_peaks({{5, 5}});
  Maps tested = expected;
  Plane<std::uint16_t> raw(40, 40, 100);
  raw(3, 4) = 104;
  tested.features[2].samples = raw;
  tested.features[2].lsb = 0.01;
  tested.feature_statistics[2].maxima = 4;
  tested.conspicuity_statistics[1].maxima = 5;
  const ImageDifference d = compare_maps(tested, expected, {});
  EXPECT_DOUBLE_EQ(d.maps[2].largest, 1.04 - 1);
  EXPECT_DOUBLE_EQ(d.maps[2].lsb, 0.01);
  EXPECT_NEAR(d.maps[2].largest_share(), 0.04, 1e-12);
  EXPECT_NEAR(d.maps[2].rms_share(), 0.04 / 40, 1e-12);
  EXPECT_EQ(d.maps[3].largest, 0);
  EXPECT_EQ(d.maps[3].lsb, 0);
  EXPECT_EQ(d.maps_of_other_m, 2);
  const Maps difference = difference_maps(tested, expected);
  EXPECT_NEAR(difference.features[2].at(3, 4), 0.04, 1e-12);
  EXPECT_EQ(difference.features[3].at(3, 4), 0);
  EXPECT_NEAR(difference.feature_statistics[2].maximum, 0.04, 1e-12);
}

TEST(Comparison, RegionsAtTheSamePlaceWhateverTheirRank) {
  const Maps expected = maps_with_peaks({{5, 5}, {25, 5}, {5, 25}, {25, 25}});
  const Maps tested = maps_with_peaks({{25, 5}, {5, 5}, {6, 24}, {29, 25}});
  const ImageDifference d = compare_maps(tested, expected, {});
  EXPECT_EQ(d.regions, 4);
  EXPECT_EQ(d.same_regions, 2);
  EXPECT_EQ(d.near_regions, 3);
}

TEST(Comparison, OnlyTheFiveMostSalientCount) {
  const Maps maps = maps_with_peaks({{5, 5}, {20, 5}, {35, 5}, {5, 20}, {20, 20}, {35, 20}, {5, 35}});
  EXPECT_EQ(compare_maps(maps, maps, {}).regions, 5);
}

TEST(Comparison, LoopsAgreeByTheImageThatMadeTheNode) {
  const TopologicalMap expected = testing::map_of({0, 1, 2, 3, 1, 4, 5, 0});
  const TopologicalMap same = testing::map_of({0, 1, 2, 3, 1, 4, 5, 0});
  LoopAgreement agreement = compare_loops(same, expected);
  EXPECT_EQ(agreement.same_verdict, 8);
  EXPECT_EQ(agreement.same_best, agreement.with_best);
  EXPECT_EQ(agreement.tested_loops, 2);
  const TopologicalMap other = testing::map_of({0, 1, 2, 3, 9, 4, 5, 1});
  agreement = compare_loops(other, expected);
  EXPECT_EQ(agreement.same_verdict, 7);
  EXPECT_EQ(agreement.tested_loops, 1);
  EXPECT_LT(agreement.same_best, agreement.with_best);
  EXPECT_THROW(compare_loops(testing::map_of({0}), expected), Error);
}

TEST(Comparison, MapsHaveNames) {
  EXPECT_EQ(map_name(0), "intensity_on");
  EXPECT_EQ(map_name(9), "ori_135");
  EXPECT_EQ(map_name(10), "conspicuity_intensity");
  EXPECT_EQ(map_name(13), "saliency");
}

}  // namespace
}  // namespace sailmap
