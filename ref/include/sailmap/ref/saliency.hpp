// Spec section 7: conspicuity maps and the saliency map, eq. 2.
#pragma once

#include <array>
#include <span>

#include "sailmap/hls/geometry.hpp"
#include "sailmap/ref/normalise.hpp"
#include "sailmap/ref/plane.hpp"
#include "sailmap/ref/policy.hpp"

namespace sailmap::ref {

// The sum of maps of one size, rounded at Point.
template <class Policy, class Point>
Plane<double> sum_of(std::span<const Plane<double>> maps) {
  Plane<double> out(maps.front().width(), maps.front().height());
  for (int y = 0; y < out.height(); ++y) {
    for (int x = 0; x < out.width(); ++x) {
      double sum = 0;
      for (const auto& map : maps) sum += map(x, y);
      out(x, y) = Policy::template at<Point>(sum);
    }
  }
  return out;
}

// C_I, C_C or C_O: the sum of the normalised feature maps of one kind, at Point.
template <class Policy, class Point>
Plane<double> conspicuity(std::span<const Plane<double>> normalised) {
  return sum_of<Policy, Point>(normalised);
}

// S = C~_I + C~_C + C~_O, each C normalised by eq. 1 again.
template <class Policy>
Plane<double> saliency(const std::array<Plane<double>, hls::geometry::conspicuity_maps>& conspicuities,
                       const std::array<MapStatistics, hls::geometry::conspicuity_maps>& statistics) {
  std::array<Plane<double>, hls::geometry::conspicuity_maps> normalised;
  for (std::size_t kind = 0; kind < conspicuities.size(); ++kind) {
    normalised[kind] =
        normalise<Policy, point::normalised_conspicuity>(conspicuities[kind], statistics[kind]);
  }
  return sum_of<Policy, point::saliency>(normalised);
}

}  // namespace sailmap::ref
