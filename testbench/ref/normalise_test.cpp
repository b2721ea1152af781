// Spec section 7, eq. 1: local maxima and normalisation, worked by hand.
#include "sailmap/ref/normalise.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "planes.hpp"

namespace sailmap {
namespace {

using testing::is_zero;
using testing::plane_of;

constexpr double tie = ref::Exact::tie;

int maxima(const Plane<double>& map) { return ref::statistics(map, tie).maxima; }

TEST(LocalMaxima, OutsideIsNoRival) {
  EXPECT_EQ(maxima(plane_of({{1}})), 1);
  EXPECT_EQ(maxima(plane_of({{4, 1, 4}, {1, 1, 1}, {4, 1, 4}})), 4);
  EXPECT_EQ(maxima(plane_of({{1, 4, 1}, {4, 1, 4}, {1, 4, 1}})), 1)
      << "corners touch: only the first is greater";
}

TEST(LocalMaxima, APlateauCountsOnce) {
  EXPECT_EQ(maxima(Plane<double>(5, 4, 2.5)), 1);
  EXPECT_EQ(maxima(plane_of({{0, 0, 0, 0}, {0, 3, 3, 0}, {0, 3, 3, 0}, {0, 0, 0, 0}})), 1);
  EXPECT_EQ(maxima(plane_of({{3, 3, 3, 0, 3}})), 2);
}

// Scanned in raster order a plateau may begin twice before its parts join: the rule, not the eye, decides.
TEST(LocalMaxima, APlateauOpenUpwardsCountsItsBeginnings) {
  EXPECT_EQ(maxima(plane_of({{3, 0, 3}, {3, 3, 3}})), 2);
  EXPECT_EQ(maxima(plane_of({{3, 3, 3}, {3, 0, 3}})), 1);
}

TEST(LocalMaxima, EachNeighbourCanDeny) {
  for (int neighbour = 0; neighbour < 9; ++neighbour) {
    if (neighbour == 4) continue;
    Plane<double> map(3, 3);
    map(1, 1) = 3;
    map(neighbour % 3, neighbour / 3) = 4;
    EXPECT_FALSE(ref::is_local_maximum(map, 1, 1)) << neighbour;
    map(neighbour % 3, neighbour / 3) = 3;
    EXPECT_EQ(ref::is_local_maximum(map, 1, 1), neighbour > 4) << neighbour;
  }
}

TEST(LocalMaxima, AtOrBelowHalfOfTheMaximumDoNotCount) {
  EXPECT_EQ(maxima(plane_of({{8, 0, 4, 0, 3, 0, 4.1, 0}})), 2);
}

// 1/3 and 1/6 arise where one of two maps has four times the other's maxima; on the grid, twice the latter is
// the greater.
TEST(LocalMaxima, HalfIsHalfInSpiteOfRounding) {
  const double third = ref::Exact::at<ref::point::normalised>(1 / 3.0);
  const double sixth = ref::Exact::at<ref::point::normalised>(1 / 6.0);
  ASSERT_GT(2 * sixth, third);
  EXPECT_EQ(maxima(plane_of({{third, 0, sixth}})), 1);
  EXPECT_EQ(maxima(plane_of({{third, 0, sixth + 1e-9}})), 2);
}

TEST(Statistics, OfAZeroMapAreZero) {
  EXPECT_EQ(ref::statistics(Plane<double>(7, 5), tie), MapStatistics{});
  EXPECT_EQ(MapStatistics{}.gain(), 0);
}

TEST(Statistics, OfAMapOfRoundingNoiseAreZero) {
  EXPECT_EQ(ref::statistics(plane_of({{ref::Exact::grid, 0, tie}}), tie), MapStatistics{});
  EXPECT_EQ(ref::statistics(plane_of({{0, 1e-9}}), tie), (MapStatistics{1e-9, 1}));
}

TEST(Normalise, DividesByTheMaximumAndTheRootOfM) {
  const Plane<double> map = plane_of({{8, 0, 6, 0, 5, 0, 7, 2}});
  const MapStatistics stats = ref::statistics(map, tie);
  EXPECT_EQ(stats, (MapStatistics{8, 4}));
  const Plane<double> out = ref::normalise<ref::Exact, ref::point::normalised>(map, stats);
  EXPECT_EQ(out, plane_of({{0.5, 0, 0.375, 0, 0.3125, 0, 0.4375, 0.125}}));
}

TEST(Normalise, FavoursTheMapWithFewPeaks) {
  const auto peak = [](const Plane<double>& map) {
    return testing::largest(
        ref::normalise<ref::Exact, ref::point::normalised>(map, ref::statistics(map, tie)));
  };
  EXPECT_EQ(peak(plane_of({{0, 0.001, 0, 0, 0}})), 1);
  EXPECT_NEAR(peak(plane_of({{9, 0, 9, 0, 9}})), 1 / std::sqrt(3.0), 1e-12);
}

TEST(Normalise, LeavesAZeroMapZero) {
  const Plane<double> zero(7, 5);
  EXPECT_TRUE(is_zero(ref::normalise<ref::Exact, ref::point::normalised>(zero, ref::statistics(zero, tie))));
}

}  // namespace
}  // namespace sailmap
