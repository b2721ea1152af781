// Spec section 5: Gabor energy of the intensity in four orientations.
#pragma once

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "sailmap/hls/geometry.hpp"
#include "sailmap/ref/gabor_filters.hpp"
#include "sailmap/ref/plane.hpp"
#include "sailmap/ref/policy.hpp"

namespace sailmap::ref {

using GaborWindow = std::array<std::array<double, hls::geometry::gabor_taps>, hls::geometry::gabor_taps>;

// sign * vertical(y) * horizontal(x), one term of a separable window.
struct SeparableTerm {
  double sign;
  GaborFilter vertical;
  GaborFilter horizontal;
};

// A window is the sum of at most three separable terms.
struct SeparablePair {
  std::vector<SeparableTerm> even;
  std::vector<SeparableTerm> odd;
};

// theta = 45 degrees x `index`, u = x cos + y sin. cos(v(x+y)) = cos vx cos vy - sin vx sin vy and so on; the
// diagonal even windows lose their DC through the product of two Gaussians that have the cosines' sum.
inline SeparablePair separable_pair(const GaborFilters& f, int index) {
  if (index == 0) return {{{1, f.gauss, f.even}}, {{1, f.gauss, f.odd}}};
  if (index == 2) return {{{1, f.even, f.gauss}}, {{1, f.odd, f.gauss}}};
  const double down = index == 1 ? 1 : -1;  // 45 degrees runs down to the right, 135 down to the left
  return {{{1, f.cosine, f.cosine}, {-down, f.sine, f.sine}, {-1, f.gauss, f.gauss}},
          {{1, f.sine, f.cosine}, {down, f.cosine, f.sine}}};
}

inline GaborWindow window_of(const std::vector<SeparableTerm>& terms) {
  GaborWindow window{};
  for (const SeparableTerm& term : terms) {
    for (std::size_t row = 0; row < window.size(); ++row) {
      for (std::size_t column = 0; column < window.size(); ++column) {
        window[row][column] += term.sign * term.vertical[row] * term.horizontal[column];
      }
    }
  }
  return window;
}

inline double absolute_sum(const GaborWindow& window) {
  double sum = 0;
  for (const auto& row : window) {
    for (const double v : row) sum += std::abs(v);
  }
  return sum;
}

struct GaborPair {
  GaborWindow even;  // [row][column], free of DC, sum of absolute values 1
  GaborWindow odd;
};

// The pair of the spec for theta = 45 degrees x `index`.
inline GaborPair gabor_pair(int index) {
  const SeparablePair terms = separable_pair(spec_gabor_filters(), index);
  const auto unit_absolute_sum = [](GaborWindow window) {
    const double sum = absolute_sum(window);
    for (auto& row : window) {
      for (double& v : row) v /= sum;
    }
    return window;
  };
  return {unit_absolute_sum(window_of(terms.even)), unit_absolute_sum(window_of(terms.odd))};
}

// The plane filtered along its columns; the hardware rounds here, so that the horizontal filters work on
// short words.
template <class Policy>
Plane<double> gabor_columns(const Plane<double>& in, const GaborFilter& filter) {
  constexpr int radius = hls::geometry::gabor_radius;
  Plane<double> out(in.width(), in.height());
  for (int y = 0; y < in.height(); ++y) {
    for (int x = 0; x < in.width(); ++x) {
      double sum = 0;
      for (std::size_t k = 0; k < filter.size(); ++k) {
        sum += filter[k] * in.clamped(x, y + static_cast<int>(k) - radius);
      }
      out(x, y) = Policy::template at<point::gabor_column>(sum);
    }
  }
  return out;
}

// |in * window|, the window not scaled.
template <class Policy>
Plane<double> gabor_response(const Plane<double>& in, const std::vector<SeparableTerm>& terms) {
  constexpr int radius = hls::geometry::gabor_radius;
  Plane<double> out(in.width(), in.height());
  for (const SeparableTerm& term : terms) {
    const Plane<double> columns = gabor_columns<Policy>(in, term.vertical);
    for (int y = 0; y < in.height(); ++y) {
      for (int x = 0; x < in.width(); ++x) {
        double sum = 0;
        for (std::size_t k = 0; k < term.horizontal.size(); ++k) {
          sum += term.horizontal[k] * columns.clamped(x + static_cast<int>(k) - radius, y);
        }
        out(x, y) += term.sign * sum;
      }
    }
  }
  for (double& v : out.samples()) v = Policy::template at<point::gabor_response>(std::abs(v));
  return out;
}

// |even| + |odd| of one level of I; `index` selects theta = 0, 45, 90 or 135 degrees.
template <class Policy>
Plane<double> gabor_energy(const Plane<double>& in, int index) {
  const SeparablePair terms = separable_pair(Policy::gabor_filters(), index);
  const auto scale = [](const std::vector<SeparableTerm>& window) {
    return Policy::template at<point::gabor_scale>(1 / absolute_sum(window_of(window)));
  };
  const double even_scale = scale(terms.even);
  const double odd_scale = scale(terms.odd);
  const Plane<double> even = gabor_response<Policy>(in, terms.even);
  const Plane<double> odd = gabor_response<Policy>(in, terms.odd);
  Plane<double> out(in.width(), in.height());
  for (int y = 0; y < in.height(); ++y) {
    for (int x = 0; x < in.width(); ++x) {
      out(x, y) = Policy::template at<point::gabor_energy>(even(x, y) * even_scale + odd(x, y) * odd_scale);
    }
  }
  return out;
}

}  // namespace sailmap::ref
