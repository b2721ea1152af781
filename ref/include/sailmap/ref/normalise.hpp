// Spec section 7, eq. 1: a map whose few peaks stand alone weighs more than one with many.
#pragma once

#include <algorithm>
#include <cmath>

#include "sailmap/ref/plane.hpp"
#include "sailmap/ref/policy.hpp"

namespace sailmap {

// What eq. 1 needs to know of a map.
struct MapStatistics {
  double maximum = 0;  // max(X), in the map's units
  int maxima = 0;      // m, local maxima above max(X)/2

  // 1 / (max(X) sqrt(m)), 0 for a flat zero map.
  [[nodiscard]] double gain() const { return maximum > 0 ? 1 / (maximum * std::sqrt(maxima)) : 0; }
  bool operator==(const MapStatistics&) const = default;
};

}  // namespace sailmap

namespace sailmap::ref {

// > the four neighbours already scanned (three above, one left), >= the other four; outside is -infinity.
inline bool is_local_maximum(const Plane<double>& map, int x, int y) {
  const double v = map(x, y);
  const auto inside = [&map](int nx, int ny) {
    return nx >= 0 && ny >= 0 && nx < map.width() && ny < map.height();
  };
  const auto above = [&](int nx, int ny) { return !inside(nx, ny) || v > map(nx, ny); };
  const auto not_below = [&](int nx, int ny) { return !inside(nx, ny) || v >= map(nx, ny); };
  return above(x - 1, y - 1) && above(x, y - 1) && above(x + 1, y - 1) && above(x - 1, y) &&
         not_below(x + 1, y) && not_below(x - 1, y + 1) && not_below(x, y + 1) && not_below(x + 1, y + 1);
}

// Local maxima are found on `sums`, their height is that in `map`: the same map as the hardware stores it,
// rounded once more. `tie`, of the policy: values this close may be equal but for rounding, so a map no
// higher is flat.
inline MapStatistics statistics(const Plane<double>& sums, const Plane<double>& map, double tie) {
  const double maximum = std::ranges::max(map.samples());
  if (maximum <= tie) return {};
  MapStatistics out{maximum, 0};
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      if (2 * map(x, y) > maximum + tie && is_local_maximum(sums, x, y)) ++out.maxima;
    }
  }
  return out;
}

inline MapStatistics statistics(const Plane<double>& map, double tie) { return statistics(map, map, tie); }

// The map rounded at Point, as it is stored.
template <class Policy, class Point>
Plane<double> stored(const Plane<double>& sums) {
  Plane<double> map = sums;
  for (double& v : map.samples()) v = Policy::template at<Point>(v);
  return map;
}

// X~ = X / (max(X) sqrt(m)).
template <class Policy, class Point>
Plane<double> normalise(const Plane<double>& map, const MapStatistics& stats) {
  const double gain = Policy::gain(stats.maximum, stats.maxima);
  Plane<double> out(map.width(), map.height());
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) out(x, y) = Policy::template at<Point>(map(x, y) * gain);
  }
  return out;
}

}  // namespace sailmap::ref
