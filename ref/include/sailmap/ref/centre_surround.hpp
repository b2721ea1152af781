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

// Mean of the (2r+1)x(2r+1) window around (x, y) without its centre, edges replicated.
inline double surround_mean(const Plane<double>& in, int x, int y, int radius) {
  double sum = 0;
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) sum += in.clamped(x + dx, y + dy);
  }
  const int side = 2 * radius + 1;
  return (sum - in(x, y)) / (side * side - 1);
}

template <class Policy, class Point>
Contrast centre_surround(const Plane<double>& in) {
  Contrast out{Plane<double>(in.width(), in.height()), Plane<double>(in.width(), in.height())};
  for (int y = 0; y < in.height(); ++y) {
    for (int x = 0; x < in.width(); ++x) {
      for (const int radius : {hls::geometry::surround_radius_small, hls::geometry::surround_radius_large}) {
        const double difference = in(x, y) - surround_mean(in, x, y, radius);
        out.on(x, y) += Policy::template at<Point>(std::max(0.0, difference));
        out.off(x, y) += Policy::template at<Point>(std::max(0.0, -difference));
      }
    }
  }
  return out;
}

}  // namespace sailmap::ref
