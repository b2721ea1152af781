#include "sailmap/ground_truth.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <iostream>
#include <vector>

#include "sailmap/simulator.hpp"

namespace sailmap {
namespace {

// Every pair, the angle between headings from the dot product of their directions.
std::vector<std::vector<int>> all_pairs(const Simulator& simulator, int images, double radius) {
  std::vector<std::vector<int>> matches(static_cast<std::size_t>(images));
  for (int q = 0; q < images; ++q)
    for (int e = 0; e < q; ++e) {
      const SimulatedPose a = simulator.pose(q);
      const SimulatedPose b = simulator.pose(e);
      const double cosine =
          std::cos(a.heading) * std::cos(b.heading) + std::sin(a.heading) * std::sin(b.heading);
      if (std::hypot(a.x - b.x, a.y - b.y) <= radius && cosine >= std::sqrt(0.5))
        matches[static_cast<std::size_t>(q)].push_back(e);
    }
  return matches;
}

TEST(SimulatedGroundTruth, IsThatOfAllPairs) {
  for (const double radius : {0.4, 3.0, 25.0}) {
    SimulationConfig config;
    config.images = 260;
    config.images_per_lap = 70;
    config.jitter = 2;
    config.match_radius = radius;
    const Simulator simulator(config);
    EXPECT_EQ(simulator.ground_truth().matches, all_pairs(simulator, config.images, radius)) << radius;
  }
}

// In the small circuit a radius of 25 m reaches the street's other side, where the camera looks elsewhere.
TEST(SimulatedGroundTruth, LeavesOutPlacesSeenTheOtherWay) {
  SimulationConfig config;
  config.images = 50;
  config.match_radius = 1000;
  const GroundTruth truth = Simulator(config).ground_truth();
  for (const int e : truth.matches[49]) EXPECT_TRUE(e < 10 || e > 35) << e;
  EXPECT_THAT(truth.matches[49], ::testing::Contains(48));
  EXPECT_THAT(truth.matches[49], ::testing::Not(::testing::Contains(25)));
}

TEST(SimulatedGroundTruth, FindsThePlaceOnEveryEarlierLap) {
  SimulationConfig config;
  config.images = 400;
  config.images_per_lap = 100;
  config.jitter = 0.5;
  const GroundTruth truth = Simulator(config).ground_truth();
  EXPECT_TRUE(truth.matches[0].empty());
  for (const int q : {310, 350, 399})
    EXPECT_THAT(truth.matches[static_cast<std::size_t>(q)],
                ::testing::IsSupersetOf({q - 300, q - 200, q - 100, q - 1}));
}

TEST(SimulatedGroundTruth, IsQuickForLongDrives) {
  SimulationConfig config;
  config.images = 50'000;
  config.images_per_lap = 5000;
  const Simulator simulator(config);
  const auto start = std::chrono::steady_clock::now();
  const GroundTruth truth = simulator.ground_truth();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  std::cout << "50 000 images: " << taken.count() << " s\n";
  ASSERT_EQ(truth.matches.size(), 50'000U);
  EXPECT_THAT(truth.matches[49'000], ::testing::Contains(4000));
}

}  // namespace
}  // namespace sailmap
