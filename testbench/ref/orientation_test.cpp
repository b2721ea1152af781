// Spec section 5, against OpenCV's Gabor kernels and its two-dimensional filter.
#include "sailmap/ref/orientation.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "planes.hpp"

namespace sailmap {
namespace {

using testing::is_zero;
using testing::largest;
using testing::largest_difference;
using testing::random_plane;
using testing::to_mat;

struct Kernels {
  cv::Mat even, odd;
};

cv::Mat opencv_gabor(double theta, double wavelength, double phase) {
  return cv::getGaborKernel({9, 9}, 7 / 3.0, theta, wavelength, 1, phase, CV_64F);
}

// Without a wave (wavelength without bound) OpenCV's kernel is the Gaussian. Its kernels are rotated by half
// a turn, which makes the cosine of phase 90 degrees, -sin(u), the sine.
Kernels opencv_pair(int index) {
  const double theta = index * CV_PI / 4;
  const cv::Mat gauss = opencv_gabor(0, 1e300, 0);
  const cv::Mat wave = opencv_gabor(theta, 7, 0);
  const cv::Mat even = wave - gauss * (cv::sum(wave)[0] / cv::sum(gauss)[0]);
  const cv::Mat odd = opencv_gabor(theta, 7, CV_PI / 2);
  return {even / cv::norm(even, cv::NORM_L1), odd / cv::norm(odd, cv::NORM_L1)};
}

cv::Mat to_mat(const ref::GaborWindow& window) {
  return testing::mat_of<double>(
      9, 9, [&](int x, int y) { return window[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)]; });
}

Plane<double> energy(const Plane<double>& in, int index) { return ref::gabor_energy<ref::Exact>(in, index); }

class Orientation : public ::testing::TestWithParam<int> {};

TEST_P(Orientation, KernelsAreOpenCVsMadeFreeOfDc) {
  const ref::GaborPair actual = ref::gabor_pair(GetParam());
  const Kernels expected = opencv_pair(GetParam());
  EXPECT_LE(cv::norm(to_mat(actual.even), expected.even, cv::NORM_INF), 1e-14);
  EXPECT_LE(cv::norm(to_mat(actual.odd), expected.odd, cv::NORM_INF), 1e-14);
  EXPECT_NEAR(cv::sum(to_mat(actual.even))[0], 0, 1e-15);
}

TEST_P(Orientation, EnergyIsThatOfOpenCVsFilter) {
  const Kernels kernels = opencv_pair(GetParam());
  for (const cv::Size size : {cv::Size(4, 4), cv::Size(25, 16), cv::Size(67, 33)}) {
    const Plane<double> in = random_plane(size.width, size.height, 1);
    cv::Mat even;
    cv::Mat odd;
    cv::filter2D(to_mat(in), even, CV_64F, kernels.even, {-1, -1}, 0, cv::BORDER_REPLICATE);
    cv::filter2D(to_mat(in), odd, CV_64F, kernels.odd, {-1, -1}, 0, cv::BORDER_REPLICATE);
    EXPECT_LE(largest_difference(energy(in, GetParam()), cv::abs(even) + cv::abs(odd)), 1e-12) << size;
  }
}

// A wave of the filter's wavelength along (x right, y down): 45 degrees runs down to the right.
TEST_P(Orientation, IsStrongestForItsOwnWave) {
  static constexpr double along[4][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}};
  const auto& [dx, dy] = along[GetParam()];
  Plane<double> wave(40, 40);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      wave(x, y) = 0.5 + 0.5 * std::cos(2 * CV_PI * (dx * x + dy * y) / std::hypot(dx, dy) / 7);
    }
  }
  const double own = energy(wave, GetParam())(20, 20);
  for (int other = 0; other < 4; ++other) {
    if (other != GetParam()) {
      EXPECT_GT(own, 2 * energy(wave, other)(20, 20)) << other;
    }
  }
}

TEST_P(Orientation, EnergyOfAFlatPlaneIsZeroToTheLastBit) {
  for (const double value : {1 / 765.0, 1 / 3.0, 1.0}) {
    EXPECT_TRUE(is_zero(energy(Plane<double>(20, 20, value), GetParam()))) << value;
  }
}

// |even| and |odd| are at most 1/2 (free of DC, unit sum of absolute values, I in [0, 1]).
TEST_P(Orientation, EnergyIsAtMostOne) {
  const ref::GaborPair pair = ref::gabor_pair(GetParam());
  Plane<double> worst(9, 9);
  for (std::size_t row = 0; row < 9; ++row) {
    for (std::size_t column = 0; column < 9; ++column) {
      worst(static_cast<int>(column), static_cast<int>(row)) = pair.odd[row][column] > 0 ? 1 : 0;
    }
  }
  const Plane<double> out = energy(worst, GetParam());
  EXPECT_GE(out(4, 4), 0.5 - 1e-12);
  EXPECT_LE(largest(out), 1);
}

INSTANTIATE_TEST_SUITE_P(Theta, Orientation, ::testing::Range(0, 4),
                         [](const auto& test) { return std::to_string(45 * test.param); });

}  // namespace
}  // namespace sailmap
