// Spec section 3: the Gaussian pyramid, separable binomial [1 4 6 4 1]/16 and every second sample.
#pragma once

#include <vector>

#include "sailmap/hls/geometry.hpp"
#include "sailmap/ref/plane.hpp"
#include "sailmap/ref/policy.hpp"

namespace sailmap::ref {

// One level: smoothed, then even rows and columns. Size w x h becomes ceil(w/2) x ceil(h/2).
template <class Policy, class Point>
Plane<double> reduce(const Plane<double>& in) {
  constexpr int binomial[] = {1, 4, 6, 4, 1};
  const int w = hls::geometry::half(in.width());
  const int h = hls::geometry::half(in.height());
  Plane<double> rows(w, in.height());
  for (int y = 0; y < in.height(); ++y) {
    for (int x = 0; x < w; ++x) {
      double sum = 0;
      for (int k = -2; k <= 2; ++k) sum += binomial[k + 2] * in.clamped(2 * x + k, y);
      rows(x, y) = sum;
    }
  }
  Plane<double> out(w, h);
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      double sum = 0;
      for (int k = -2; k <= 2; ++k) sum += binomial[k + 2] * rows.clamped(x, 2 * y + k);
      out(x, y) = Policy::template at<Point>(sum / 256);
    }
  }
  return out;
}

// Levels 0 to `top_level` of one channel; element l is level l.
template <class Policy, class Point>
std::vector<Plane<double>> pyramid(Plane<double> channel) {
  std::vector<Plane<double>> levels;
  levels.push_back(std::move(channel));
  for (int level = 1; level <= hls::geometry::top_level; ++level) {
    levels.push_back(reduce<Policy, Point>(levels.back()));
  }
  return levels;
}

}  // namespace sailmap::ref
