// Spec section 8: salient regions and their descriptors, eq. 3-4, from the maps of a Model. Under the policy
// Quantised it is the golden model of the kernel signature.hpp, word for word.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "sailmap/hls/geometry.hpp"
#include "sailmap/ref/model.hpp"
#include "sailmap/ref/plane.hpp"
#include "sailmap/ref/policy.hpp"

namespace sailmap::ref {

struct RegionParameters {
  int max_regions = 20;
  double stop_ratio = 0.25;
  int box_side = 10;  // base-level pixels
};

struct SalientRegion {
  int x = 0;  // base-level pixels
  int y = 0;
  double saliency = 0;
  std::array<double, hls::geometry::feature_maps> descriptor{};
};

// Base-level pixels [x0, x1) x [y0, y1).
struct RegionBox {
  int x0, y0, x1, y1;
};

// [x - side/2, x + side/2) and so in y, cut at the map's border.
inline RegionBox region_box(int x, int y, int side, int width, int height) {
  return {std::max(0, x - side / 2), std::max(0, y - side / 2), std::min(width, x - side / 2 + side),
          std::min(height, y - side / 2 + side)};
}

// Exact: maps are on a grid far coarser than a double's last bit.
template <class Policy, class Point>
double region_sum(const Plane<double>& map, const RegionBox& box) {
  double sum = 0;
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) sum += map(x, y);
  }
  return Policy::template at<Point>(sum);
}

// Eq. 3-4 of the maps [First, First + Count) of one kind: a ratio of means over one box is a ratio of sums.
// Of the quantised policy's numbers the double quotient is exact enough for its rounding: a quotient of 40
// bits by 26 that is no half of a unit in the last place is 2^-27 of it away from one, a double's own
// rounding 2^-29.
template <class Policy, class FeatureSum, class ConspicuitySum, std::size_t First, std::size_t Count>
void describe_kind(const Model& model, std::size_t kind, const RegionBox& box, SalientRegion& out) {
  const double conspicuity = region_sum<Policy, ConspicuitySum>(model.conspicuities[kind], box);
  if (conspicuity <= 0) return;
  for (std::size_t i = First; i < First + Count; ++i) {
    const MapStatistics& statistics = model.feature_statistics[i];
    const double normalised = Policy::template at<point::normalised_region_sum>(
        region_sum<Policy, FeatureSum>(model.features[i], box) *
        Policy::gain(statistics.maximum, statistics.maxima));
    out.descriptor[i] = Policy::template at<point::descriptor_entry>(normalised / conspicuity);
  }
}

// Repeated arg-max, first in raster order on ties, with the box as inhibition of return.
template <class Policy>
std::vector<SalientRegion> salient_regions(const Model& model, const RegionParameters& parameters) {
  using namespace hls::geometry;
  Plane<double> saliency = model.saliency;
  std::vector<SalientRegion> regions;
  while (regions.size() < static_cast<std::size_t>(parameters.max_regions)) {
    const auto samples = saliency.samples();
    const auto at = static_cast<int>(std::max_element(samples.begin(), samples.end()) - samples.begin());
    SalientRegion region{
        at % saliency.width(), at / saliency.width(), samples[static_cast<std::size_t>(at)], {}};
    if (region.saliency <= 0) break;
    if (!regions.empty() && region.saliency <= regions.front().saliency * parameters.stop_ratio) break;
    const RegionBox box =
        region_box(region.x, region.y, parameters.box_side, saliency.width(), saliency.height());
    describe_kind<Policy, point::intensity_region_sum, point::intensity_conspicuity_region_sum, 0,
                  intensity_maps>(model, 0, box, region);
    describe_kind<Policy, point::colour_region_sum, point::colour_conspicuity_region_sum, intensity_maps,
                  colour_maps>(model, 1, box, region);
    describe_kind<Policy, point::orientation_region_sum, point::orientation_conspicuity_region_sum,
                  intensity_maps + colour_maps, orientation_maps>(model, 2, box, region);
    regions.push_back(region);
    for (int y = box.y0; y < box.y1; ++y) {
      for (int x = box.x0; x < box.x1; ++x) saliency(x, y) = 0;
    }
  }
  return regions;
}

}  // namespace sailmap::ref
