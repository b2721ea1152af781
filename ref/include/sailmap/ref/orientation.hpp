// Spec section 5: Gabor energy of the intensity in four orientations.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "sailmap/hls/geometry.hpp"
#include "sailmap/ref/plane.hpp"
#include "sailmap/ref/policy.hpp"

namespace sailmap::ref {

using GaborWindow = std::array<std::array<double, hls::geometry::gabor_taps>, hls::geometry::gabor_taps>;

// Row or column of a Gabor window at `offset` pixels from its centre.
inline std::size_t gabor_index(int offset) {
  const int index = offset + hls::geometry::gabor_radius;
  return static_cast<std::size_t>(index);
}

struct GaborPair {
  GaborWindow even;  // [row][column], free of DC, sum of absolute values 1
  GaborWindow odd;
};

// The pair for theta = 45 degrees x `index`: wavelength 7, isotropic Gaussian of sigma 7/3, u = x cos + y
// sin.
inline GaborPair gabor_pair(int index) {
  constexpr int radius = hls::geometry::gabor_radius;
  constexpr double wavelength = 7;
  constexpr double sigma = wavelength / 3;
  const double theta = index * std::numbers::pi / 4;
  GaborPair pair{};
  GaborWindow gauss{};
  double even_sum = 0;
  double gauss_sum = 0;
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) {
      const std::size_t row = gabor_index(y);
      const std::size_t column = gabor_index(x);
      const double phase = 2 * std::numbers::pi * (x * std::cos(theta) + y * std::sin(theta)) / wavelength;
      const double g = std::exp(-(x * x + y * y) / (2 * sigma * sigma));
      gauss[row][column] = g;
      pair.even[row][column] = g * std::cos(phase);
      pair.odd[row][column] = g * std::sin(phase);
      even_sum += pair.even[row][column];
      gauss_sum += g;
    }
  }
  const auto unit_absolute_sum = [](GaborWindow& window) {
    double sum = 0;
    for (const auto& row : window) {
      for (const double v : row) sum += std::abs(v);
    }
    for (auto& row : window) {
      for (double& v : row) v /= sum;
    }
  };
  for (std::size_t row = 0; row < gauss.size(); ++row) {
    for (std::size_t column = 0; column < gauss.size(); ++column) {
      pair.even[row][column] -= gauss[row][column] * even_sum / gauss_sum;
    }
  }
  unit_absolute_sum(pair.even);
  unit_absolute_sum(pair.odd);
  return pair;
}

// |even| + |odd| of one level of I; `index` selects theta = 0, 45, 90 or 135 degrees.
template <class Policy>
Plane<double> gabor_energy(const Plane<double>& in, int index) {
  constexpr int radius = hls::geometry::gabor_radius;
  const GaborPair pair = gabor_pair(index);
  Plane<double> out(in.width(), in.height());
  for (int y = 0; y < in.height(); ++y) {
    for (int x = 0; x < in.width(); ++x) {
      double even = 0;
      double odd = 0;
      for (int dy = -radius; dy <= radius; ++dy) {
        for (int dx = -radius; dx <= radius; ++dx) {
          const std::size_t row = gabor_index(dy);
          const std::size_t column = gabor_index(dx);
          const double v = in.clamped(x + dx, y + dy);
          even += pair.even[row][column] * v;
          odd += pair.odd[row][column] * v;
        }
      }
      out(x, y) = Policy::template at<point::gabor_energy>(std::abs(even) + std::abs(odd));
    }
  }
  return out;
}

}  // namespace sailmap::ref
