// Spec section 3, against OpenCV's separable filter and its pyramid, and by hand.
#include "sailmap/ref/pyramid.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <vector>

#include "planes.hpp"

namespace sailmap {
namespace {

using testing::largest_difference;
using testing::mat_of;
using testing::plane_of;
using testing::random_plane;
using testing::to_mat;

Plane<double> reduce(const Plane<double>& in) { return ref::reduce<ref::Exact, ref::point::colour>(in); }

TEST(Reduce, SpreadsAPixelByTheBinomial) {
  Plane<double> in(9, 9);
  in(4, 4) = 256;
  EXPECT_EQ(reduce(in), plane_of({{0, 0, 0, 0, 0},  //
                                  {0, 1, 6, 1, 0},
                                  {0, 6, 36, 6, 0},
                                  {0, 1, 6, 1, 0},
                                  {0, 0, 0, 0, 0}}));
}

// At x = 0 the edge pixel counts for x = -2, -1 and 0: 1 + 4 + 6 of 16.
TEST(Reduce, ReplicatesTheEdge) {
  EXPECT_EQ(reduce(plane_of({{16, 0, 0, 0}})), plane_of({{11, 1}}));
  EXPECT_EQ(reduce(plane_of({{0, 0, 0, 16}})), plane_of({{0, 5}}));
  EXPECT_EQ(reduce(plane_of({{0, 0, 16}})), plane_of({{1, 11}}));
  EXPECT_EQ(reduce(plane_of({{16}, {0}, {0}, {0}})), plane_of({{11}, {1}}));
  EXPECT_EQ(reduce(plane_of({{16}})), plane_of({{16}}));
}

class ReduceOfSize : public ::testing::TestWithParam<cv::Size> {};

TEST_P(ReduceOfSize, IsOpenCVsFilterAndEverySecondSample) {
  const Plane<double> in = random_plane(GetParam().width, GetParam().height, 3);
  const cv::Mat binomial = (cv::Mat_<double>(1, 5) << 1, 4, 6, 4, 1) / 16;
  cv::Mat smooth;
  cv::sepFilter2D(to_mat(in), smooth, CV_64F, binomial, binomial, cv::Point(-1, -1), 0, cv::BORDER_REPLICATE);
  const cv::Mat expected = mat_of<double>((smooth.cols + 1) / 2, (smooth.rows + 1) / 2,
                                          [&](int x, int y) { return smooth.at<double>(2 * y, 2 * x); });
  EXPECT_LE(largest_difference(reduce(in), expected), 1e-12);
}

// pyrDown differs by default, in its border (reflected).
TEST_P(ReduceOfSize, IsOpenCVsPyramidWithTheEdgeReplicated) {
  const Plane<double> in = random_plane(GetParam().width, GetParam().height, 1, 2);
  cv::Mat expected;
  cv::pyrDown(to_mat(in), expected, cv::Size(), cv::BORDER_REPLICATE);
  EXPECT_LE(largest_difference(reduce(in), expected), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Sizes, ReduceOfSize,
                         ::testing::Values(cv::Size(64, 64), cv::Size(65, 97), cv::Size(101, 67),
                                           cv::Size(127, 64), cv::Size(9, 5), cv::Size(6, 7)));

TEST(Reduce, KeepsAFlatPlaneFlatToTheLastBit) {
  const double value = std::rint(0x1p40 / 3) * 0x1p-40;
  EXPECT_EQ(reduce(Plane<double>(33, 20, value)), Plane<double>(17, 10, value));
}

TEST(Pyramid, HasFiveLevelsOfHalvedSize) {
  const auto levels = ref::pyramid<ref::Exact, ref::point::intensity>(random_plane(101, 67, 1));
  std::vector<cv::Size> sizes;
  sizes.reserve(levels.size());
  for (const auto& level : levels) sizes.emplace_back(level.width(), level.height());
  EXPECT_EQ(sizes, (std::vector<cv::Size>{{101, 67}, {51, 34}, {26, 17}, {13, 9}, {7, 5}}));
  EXPECT_EQ(levels[0], random_plane(101, 67, 1));
  EXPECT_EQ(levels[4], reduce(reduce(reduce(reduce(levels[0])))));
}

}  // namespace
}  // namespace sailmap
