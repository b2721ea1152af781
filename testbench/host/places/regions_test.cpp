// Spec section 8: regions by arg-max and inhibition of return, on maps small enough to check by hand.
#include <gmock/gmock.h>

#include <cmath>

#include "sailmap/error.hpp"
#include "sailmap/signature.hpp"

namespace sailmap {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Map map_of(Plane<double> plane) {
  Map map;
  map.samples = std::move(plane);
  return map;
}

std::vector<std::array<double, 3>> triples(const std::vector<Peak>& peaks) {
  std::vector<std::array<double, 3>> out;
  for (const Peak& p : peaks) out.push_back({static_cast<double>(p.x), static_cast<double>(p.y), p.saliency});
  return out;
}

TEST(Regions, BoxIsCutAtTheBorder) {
  EXPECT_EQ(region_box({20, 30, 1}, 10, 100, 100), (Box{15, 25, 25, 35}));
  EXPECT_EQ(region_box({2, 97, 1}, 10, 100, 100), (Box{0, 92, 7, 100}));
  EXPECT_EQ(region_box({20, 30, 1}, 5, 100, 100), (Box{18, 28, 23, 33}));
}

TEST(Regions, ComeByFallingSaliencyAndStopAtAQuarter) {
  Plane<double> s(60, 40);
  s(10, 10) = 4;
  s(30, 10) = 8;
  s(50, 10) = 2.01;
  s(50, 30) = 2;  // not above 8 / 4
  EXPECT_THAT(
      triples(find_peaks(map_of(s), {})),
      ElementsAre(std::array{30.0, 10.0, 8.0}, std::array{10.0, 10.0, 4.0}, std::array{50.0, 10.0, 2.01}));
}

TEST(Regions, TiesGoToTheFirstInRasterOrder) {
  Plane<double> s(60, 40);
  s(50, 5) = 1;
  s(5, 20) = 1;
  s(40, 5) = 1;
  const auto peaks = triples(find_peaks(map_of(s), {}));
  EXPECT_THAT(
      peaks, ElementsAre(std::array{40.0, 5.0, 1.0}, std::array{50.0, 5.0, 1.0}, std::array{5.0, 20.0, 1.0}));
}

TEST(Regions, FlatMapsHaveNoneAndTheFirstIsAlwaysTaken) {
  EXPECT_THAT(find_peaks(map_of(Plane<double>(20, 20)), {}), IsEmpty());
  Plane<double> one(20, 20);
  one(3, 4) = 1e-9;
  RegionConfig config;
  config.stop_ratio = 1;
  EXPECT_EQ(find_peaks(map_of(one), config).size(), 1U);
}

TEST(Regions, TheBoxInhibitsHalfOpen) {
  // Peak at (20, 20): the box [15, 25) hides 15 and 24, but neither 14 nor 25.
  for (const auto& [x, expected] : {std::pair{14, 2U}, {15, 1U}, {24, 1U}, {25, 2U}}) {
    Plane<double> s(40, 40);
    s(20, 20) = 2;
    s(x, 20) = 1;
    EXPECT_EQ(find_peaks(map_of(s), {}).size(), expected) << x;
  }
}

TEST(Regions, TheDiskLeavesTheCornersOfTheBox) {
  Plane<double> s(40, 40);
  s(20, 20) = 2;
  s(16, 16) = 1;  // inside the box, 5.7 pixels away
  s(20, 25) = 1;  // outside the box, 5 pixels away
  RegionConfig config;
  EXPECT_EQ(find_peaks(map_of(s), config).size(), 2U);
  config.inhibition = Inhibition::disk;
  EXPECT_THAT(triples(find_peaks(map_of(s), config)),
              ElementsAre(std::array{20.0, 20.0, 2.0}, std::array{16.0, 16.0, 1.0}));
}

TEST(Regions, TheGaussianLeavesAPartThatGrowsWithDistance) {
  Plane<double> s(60, 60);
  s(30, 30) = 2;
  s(35, 30) = 1.9;
  RegionConfig config;
  config.inhibition = Inhibition::gaussian;
  config.inhibition_radius = 5;
  config.stop_ratio = 0.1;
  config.max_regions = 2;
  const auto peaks = find_peaks(map_of(s), config);
  ASSERT_EQ(peaks.size(), 2U);
  EXPECT_EQ(peaks[1].x, 35);
  EXPECT_NEAR(peaks[1].saliency, 1.9 * (1 - std::exp(-0.5)), 1e-12);
}

TEST(Regions, AtMostSoMany) {
  Plane<double> s(200, 200);
  for (int y = 5; y < 200; y += 11) {
    for (int x = 5; x < 200; x += 11) s(x, y) = 1;
  }
  EXPECT_EQ(find_peaks(map_of(s), {}).size(), 20U);
  RegionConfig config;
  config.max_regions = 3;
  EXPECT_EQ(find_peaks(map_of(s), config).size(), 3U);
}

TEST(Regions, RefuseConfigurationsOutOfRange) {
  const auto fault = [](auto change) {
    RegionConfig config;
    change(config);
    EXPECT_THROW(find_peaks(map_of(Plane<double>(9, 9)), config), Error);
  };
  fault([](RegionConfig& c) { c.max_regions = 0; });
  fault([](RegionConfig& c) { c.stop_ratio = 1.5; });
  fault([](RegionConfig& c) { c.stop_ratio = std::nan(""); });
  fault([](RegionConfig& c) { c.box_side = 1; });
  fault([](RegionConfig& c) { c.inhibition_radius = 0; });
}

}  // namespace
}  // namespace sailmap
