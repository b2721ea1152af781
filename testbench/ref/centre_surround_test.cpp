// Spec section 4, against OpenCV's box filter, and by hand.
#include "sailmap/ref/centre_surround.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <opencv2/imgproc.hpp>

#include "planes.hpp"

namespace sailmap {
namespace {

using testing::is_zero;
using testing::largest_difference;
using testing::random_plane;
using testing::to_mat;

ref::Contrast centre_surround(const Plane<double>& in) {
  return ref::centre_surround<ref::Exact, ref::point::colour_contrast>(in);
}

TEST(CentreSurround, OfABrightPixelIsWorkedByHand) {
  constexpr int centre = 20;
  Plane<double> in(41, 41);
  in(centre, centre) = 1;
  const auto [on, off] = centre_surround(in);
  for (int y = 0; y < 41; ++y) {
    for (int x = 0; x < 41; ++x) {
      const int distance = std::max(std::abs(x - centre), std::abs(y - centre));
      EXPECT_EQ(on(x, y), distance == 0 ? 2 : 0) << x << ' ' << y;
      const double seen = (distance <= 3 ? 1 / 48.0 : 0) + (distance <= 7 ? 1 / 224.0 : 0);
      EXPECT_NEAR(off(x, y), distance == 0 ? 0 : seen, 1e-12) << x << ' ' << y;
    }
  }
}

// A bright corner stands for all the pixels beyond it: 16 of 49, and 64 of 225, less the centre.
TEST(CentreSurround, ReplicatesTheEdge) {
  Plane<double> in(30, 30);
  in(0, 0) = 1;
  const auto [on, off] = centre_surround(in);
  EXPECT_NEAR(on(0, 0), (1 - 15 / 48.0) + (1 - 63 / 224.0), 1e-12);
  EXPECT_NEAR(off(1, 0), 12 / 48.0 + 56 / 224.0, 1e-12);
  EXPECT_NEAR(off(7, 7), 1 / 224.0, 1e-12);
  EXPECT_EQ(off(8, 0), 0);
}

// The radii count apart: a pixel may be brighter than its near surround and darker than the far one.
TEST(CentreSurround, CutsBelowZeroBeforeItSums) {
  Plane<double> in(31, 31, 1);
  for (int y = 11; y <= 19; ++y) {
    for (int x = 11; x <= 19; ++x) in(x, y) = 0;
  }
  in(15, 15) = 0.5;
  const auto [on, off] = centre_surround(in);
  EXPECT_NEAR(on(15, 15), 0.5, 1e-12);
  EXPECT_NEAR(off(15, 15), 144 / 224.0 - 0.5, 1e-12);
}

TEST(CentreSurround, OfAFlatPlaneIsZeroToTheLastBit) {
  for (const double value : {0.0, 1.0, 3.0, std::rint(0x1p40 / 3) * 0x1p-40, 3 - 0x1p-40}) {
    const auto [on, off] = centre_surround(Plane<double>(33, 21, value));
    EXPECT_TRUE(is_zero(on) && is_zero(off)) << value;
  }
}

class CentreSurroundOfSize : public ::testing::TestWithParam<cv::Size> {};

TEST_P(CentreSurroundOfSize, IsThatOfOpenCVsBoxFilter) {
  const Plane<double> in = random_plane(GetParam().width, GetParam().height, 3);
  const cv::Mat centre = to_mat(in);
  cv::Mat on = cv::Mat::zeros(centre.size(), CV_64F);
  cv::Mat off = on.clone();
  for (const int side : {7, 15}) {
    cv::Mat window;
    cv::boxFilter(centre, window, CV_64F, {side, side}, {-1, -1}, false, cv::BORDER_REPLICATE);
    const cv::Mat difference = centre - (window - centre) / (side * side - 1);
    on += cv::max(difference, 0);
    off += cv::max(-difference, 0);
  }
  const ref::Contrast actual = centre_surround(in);
  EXPECT_LE(largest_difference(actual.on, on), 1e-11);
  EXPECT_LE(largest_difference(actual.off, off), 1e-11);
}

// 4x4 is the least top level, smaller than the windows.
INSTANTIATE_TEST_SUITE_P(Sizes, CentreSurroundOfSize,
                         ::testing::Values(cv::Size(4, 4), cv::Size(16, 25), cv::Size(64, 7),
                                           cv::Size(101, 67)));

// What policy.hpp says of the grid: sums are exact at the largest values, so any order of summation gives
// these bits.
TEST(WindowSums, AreExactOnTheGrid) {
  const Plane<double> in(20, 20, 3 - 0x1p-40);
  const Plane<double> sums = ref::window_sums(in, 7);
  EXPECT_EQ(sums(10, 10), 675 - 225 * 0x1p-40);
  Plane<double> integers(20, 20, 3 * 0x1p40 - 1);
  EXPECT_EQ(ref::window_sums(integers, 7)(10, 10), static_cast<double>(225LL * (3LL * (1LL << 40) - 1)));
}

}  // namespace
}  // namespace sailmap
