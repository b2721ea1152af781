// Spec section 4: centre-surround contrast of one pyramid level, on and off, summed over the two radii.
#pragma once

#include <algorithm>

#include "sailmap/hls/geometry.hpp"
#include "sailmap/ref/plane.hpp"
#include "sailmap/ref/policy.hpp"

namespace sailmap::ref {

struct Contrast {
  Plane<double> on;   // max(0, centre - surround): bright on dark
  Plane<double> off;  // max(0, surround - centre): dark on bright
};

// Sum over the (2r+1)x(2r+1) window around each pixel, edges replicated: along the rows, then down the
// columns.
inline Plane<double> window_sums(const Plane<double>& in, int radius) {
  Plane<double> rows(in.width(), in.height());
  for (int y = 0; y < in.height(); ++y) {
    for (int x = 0; x < in.width(); ++x) {
      for (int dx = -radius; dx <= radius; ++dx) rows(x, y) += in.clamped(x + dx, y);
    }
  }
  Plane<double> sums(in.width(), in.height());
  for (int y = 0; y < in.height(); ++y) {
    for (int dy = -radius; dy <= radius; ++dy) {
      for (int x = 0; x < in.width(); ++x) sums(x, y) += rows.clamped(x, y + dy);
    }
  }
  return sums;
}

// side^2 times the centre less the window sum is side^2 - 1 times (centre - surround), the surround being the
// mean of the window without its centre: 48 and 224 times, and 672 has both as factors.
template <class Policy, class Point>
Contrast centre_surround(const Plane<double>& in) {
  constexpr int common = 672;
  Contrast out{Plane<double>(in.width(), in.height()), Plane<double>(in.width(), in.height())};
  for (const int radius : {hls::geometry::surround_radius_small, hls::geometry::surround_radius_large}) {
    const int area = (2 * radius + 1) * (2 * radius + 1);
    const int factor = common / (area - 1);
    const Plane<double> sums = window_sums(in, radius);
    for (int y = 0; y < in.height(); ++y) {
      for (int x = 0; x < in.width(); ++x) {
        const double difference = (area * in(x, y) - sums(x, y)) * factor;
        out.on(x, y) += std::max(0.0, difference);
        out.off(x, y) += std::max(0.0, -difference);
      }
    }
  }
  for (Plane<double>* map : {&out.on, &out.off}) {
    for (double& v : map->samples()) v = Policy::template at<Point>(v / Policy::contrast_divisor);
  }
  return out;
}

}  // namespace sailmap::ref
