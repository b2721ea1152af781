// Spec section 6: the maps of the levels become one feature map of the base level.
#pragma once

#include <algorithm>
#include <array>

#include "sailmap/hls/geometry.hpp"
#include "sailmap/ref/plane.hpp"
#include "sailmap/ref/policy.hpp"

namespace sailmap::ref {

// Linear interpolation on the sample grid to width x height, the next finer level: even positions are exact,
// odd ones the mean of their two neighbours, of which the last is replicated.
inline Plane<double> interpolate(const Plane<double>& coarse, int width, int height) {
  Plane<double> out(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int x0 = x / 2;
      const int y0 = y / 2;
      const int x1 = x0 + x % 2;
      const int y1 = y0 + y % 2;
      out(x, y) = (coarse.clamped(x0, y0) + coarse.clamped(x1, y0) + coarse.clamped(x0, y1) +
                   coarse.clamped(x1, y1)) /
                  4;
    }
  }
  return out;
}

// `levels`: one map per pyramid level, finest first. The sums are rounded at Sum on the base level, at
// Partial on the levels before it.
template <class Policy, class Partial, class Sum = Partial>
Plane<double> across_scales(const std::array<Plane<double>, hls::geometry::map_levels>& levels) {
  Plane<double> sum = levels.back();
  for (std::size_t level = levels.size() - 1; level-- > 0;) {
    const Plane<double>& finer = levels[level];
    Plane<double> next = interpolate(sum, finer.width(), finer.height());
    for (int y = 0; y < finer.height(); ++y) {
      for (int x = 0; x < finer.width(); ++x) {
        const double both = next(x, y) + finer(x, y);
        if (level == 0) {
          next(x, y) = Policy::template at<Sum>(both);
        } else {
          next(x, y) = Policy::template at<Partial>(both);
        }
      }
    }
    sum = std::move(next);
  }
  return sum;
}

}  // namespace sailmap::ref
