// Planes and images for the tests of the reference: made by hand or at random, to and from OpenCV, compared.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <opencv2/core.hpp>
#include <random>
#include <vector>

#include "sailmap/ref/plane.hpp"

namespace sailmap::testing {

// Rows of one length each, as they are written.
inline Plane<double> plane_of(std::initializer_list<std::initializer_list<double>> rows) {
  Plane<double> out(static_cast<int>(rows.begin()->size()), static_cast<int>(rows.size()));
  auto sample = out.samples().begin();
  for (const auto& row : rows) sample = std::ranges::copy(row, sample).out;
  return out;
}

// Uniform in [0, maximum), on the grid of the exact policy as all that the reference filters is.
inline Plane<double> random_plane(int width, int height, double maximum, unsigned seed = 1) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(0, maximum);
  Plane<double> out(width, height);
  for (double& v : out.samples()) v = std::rint(std::ldexp(uniform(generator), 40)) * 0x1p-40;
  return out;
}

// value_at(x, y) at each place.
template <class T, class ValueAt>
cv::Mat_<T> mat_of(int width, int height, ValueAt value_at) {
  cv::Mat_<T> out(height, width);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) out(y, x) = value_at(x, y);
  }
  return out;
}

inline cv::Mat to_mat(const Plane<double>& plane) {
  cv::Mat out(plane.height(), plane.width(), CV_64F);
  std::ranges::copy(plane.samples(), out.begin<double>());
  return out;
}

// Infinite when the sizes differ.
inline double largest_difference(const Plane<double>& plane, const cv::Mat& expected) {
  if (plane.width() != expected.cols || plane.height() != expected.rows || expected.type() != CV_64F) {
    return std::numeric_limits<double>::infinity();
  }
  return cv::norm(to_mat(plane), expected, cv::NORM_INF);
}

inline double largest(const Plane<double>& plane) { return std::ranges::max(plane.samples()); }

inline bool is_zero(const Plane<double>& plane) {
  return std::ranges::all_of(plane.samples(), [](double v) { return v == 0; });
}

struct Rgb {
  int r, g, b;
};

// An 8-bit RGB image that owns its pixels.
class Image {
 public:
  Image(int width, int height, Rgb fill = {0, 0, 0}) : pixels_(height, width, cv::Vec3b(bytes(fill))) {}

  void set(int x, int y, Rgb colour) { pixels_(y, x) = bytes(colour); }
  [[nodiscard]] const cv::Mat_<cv::Vec3b>& rgb() const { return pixels_; }
  [[nodiscard]] ImageView view() const {
    return {pixels_.cols, pixels_.rows, pixels_.data, static_cast<std::ptrdiff_t>(pixels_.step),
            ChannelOrder::rgb};
  }

  // Every pixel set to colour_at(x, y).
  template <class ColourAt>
  static Image painted(int width, int height, ColourAt colour_at) {
    Image out(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) out.set(x, y, colour_at(x, y));
    }
    return out;
  }

  static Image noise(int width, int height, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_int_distribution<int> byte(0, 255);
    return painted(width, height, [&](int, int) {
      const int r = byte(generator);
      const int g = byte(generator);
      return Rgb{r, g, byte(generator)};
    });
  }

 private:
  static cv::Vec3b bytes(Rgb c) {
    return {static_cast<std::uint8_t>(c.r), static_cast<std::uint8_t>(c.g), static_cast<std::uint8_t>(c.b)};
  }

  cv::Mat_<cv::Vec3b> pixels_;
};

}  // namespace sailmap::testing
