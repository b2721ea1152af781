// Spec section 6, worked by hand and against OpenCV's remap.
#include "sailmap/ref/across_scales.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "planes.hpp"

namespace sailmap {
namespace {

using testing::largest_difference;
using testing::mat_of;
using testing::plane_of;
using testing::random_plane;
using testing::to_mat;

TEST(Interpolate, ToAnOddSizeEndsOnASample) {
  EXPECT_EQ(ref::interpolate(plane_of({{0, 4}, {8, 12}}), 3, 3), plane_of({{0, 2, 4},  //
                                                                           {4, 6, 8},
                                                                           {8, 10, 12}}));
}

TEST(Interpolate, ToAnEvenSizeReplicatesTheLastSample) {
  EXPECT_EQ(ref::interpolate(plane_of({{0, 4}, {8, 12}}), 4, 4), plane_of({{0, 2, 4, 4},  //
                                                                           {4, 6, 8, 8},
                                                                           {8, 10, 12, 12},
                                                                           {8, 10, 12, 12}}));
}

TEST(Interpolate, ToDifferentParities) {
  EXPECT_EQ(ref::interpolate(plane_of({{0, 4}, {8, 12}}), 4, 3), plane_of({{0, 2, 4, 4},  //
                                                                           {4, 6, 8, 8},
                                                                           {8, 10, 12, 12}}));
  EXPECT_EQ(ref::interpolate(plane_of({{1}}), 2, 1), plane_of({{1, 1}}));
}

class InterpolateToSize : public ::testing::TestWithParam<cv::Size> {};

TEST_P(InterpolateToSize, IsOpenCVsRemapAtHalfTheCoordinates) {
  const auto [width, height] = GetParam();
  const Plane<double> coarse = random_plane((width + 1) / 2, (height + 1) / 2, 2);
  const cv::Mat half = mat_of<cv::Point2f>(width, height, [](int x, int y) { return cv::Point2d(x, y) / 2; });
  cv::Mat expected;
  cv::remap(to_mat(coarse), expected, half, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  EXPECT_LE(largest_difference(ref::interpolate(coarse, width, height), expected), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Sizes, InterpolateToSize,
                         ::testing::Values(cv::Size(16, 16), cv::Size(17, 25), cv::Size(26, 17),
                                           cv::Size(32, 9)));

Plane<double> across_scales(const Plane<double>& fine, const Plane<double>& middle,
                            const Plane<double>& coarse) {
  return ref::across_scales<ref::Exact, ref::point::intensity_feature>({fine, middle, coarse});
}

TEST(AcrossScales, AddsTheLevelsOnTheWayDown) {
  // The coarse 8 becomes 8 4 0 at the middle level, 9 4 0 with its 1, then linear at the fine one.
  EXPECT_EQ(across_scales(plane_of({{0, 0, 0, 0, 100}}), plane_of({{1, 0, 0}}), plane_of({{8, 0}})),
            plane_of({{9, 6.5, 4, 2, 100}}));
}

TEST(AcrossScales, IsTheSumWhereAllLevelsAreFlat) {
  EXPECT_EQ(across_scales(Plane<double>(26, 17, 1), Plane<double>(13, 9, 10), Plane<double>(7, 5, 100)),
            Plane<double>(26, 17, 111));
}

}  // namespace
}  // namespace sailmap
