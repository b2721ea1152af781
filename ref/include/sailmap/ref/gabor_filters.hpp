// Spec section 5: the 1-D filters whose products are the Gabor windows, in real numbers and in the hardware's
// integers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>

#include "sailmap/hls/gabor_coefficients.hpp"
#include "sailmap/hls/geometry.hpp"

namespace sailmap::ref {

using GaborFilter = std::array<double, hls::geometry::gabor_taps>;

// With g the Gaussian of sigma 7/3, w = 2 pi/7 and v = w/sqrt(2), each free to have a scale:
struct GaborFilters {
  GaborFilter even;    // g (cos wx - DC)
  GaborFilter odd;     // g sin wx
  GaborFilter cosine;  // g cos vx; this and the next two share one scale
  GaborFilter sine;    // g sin vx
  GaborFilter gauss;   // g, with the sum of `cosine`
};

// Wavelength 7, isotropic Gaussian of sigma 7/3.
inline GaborFilters spec_gabor_filters() {
  constexpr double wave = 2 * std::numbers::pi / 7;
  constexpr double diagonal = wave / std::numbers::sqrt2;
  constexpr double sigma = 7 / 3.0;
  GaborFilters f{};
  for (std::size_t i = 0; i < f.gauss.size(); ++i) {
    const double x = static_cast<int>(i) - hls::geometry::gabor_radius;
    const double g = std::exp(-x * x / (2 * sigma * sigma));
    f.even[i] = g * std::cos(wave * x);
    f.odd[i] = g * std::sin(wave * x);
    f.cosine[i] = g * std::cos(diagonal * x);
    f.sine[i] = g * std::sin(diagonal * x);
    f.gauss[i] = g;
  }
  const auto sum = [](const GaborFilter& filter) {
    return std::accumulate(filter.begin(), filter.end(), 0.0);
  };
  const double dc = sum(f.even) / sum(f.gauss);
  const double diagonal_dc = sum(f.cosine) / sum(f.gauss);
  for (std::size_t i = 0; i < f.gauss.size(); ++i) {
    f.even[i] -= dc * f.gauss[i];
    f.gauss[i] *= diagonal_dc;
  }
  return f;
}

// The integers of the kernels.
inline GaborFilters integer_gabor_filters() {
  const auto real = [](const int(&taps)[hls::gabor::taps]) {
    GaborFilter out{};
    std::copy(std::begin(taps), std::end(taps), out.begin());
    return out;
  };
  using namespace hls::gabor;
  return {real(E), real(O), real(C), real(S), real(G)};
}

}  // namespace sailmap::ref
