// Spec section 8: salient regions by repeated arg-max with inhibition of return.
#include <algorithm>
#include <cmath>
#include <string>

#include "sailmap/error.hpp"
#include "sailmap/signature.hpp"

namespace sailmap {
namespace {

void check(const RegionConfig& config) {
  const auto demand = [](bool holds, const char* fault) {
    if (!holds) throw Error(std::string("region configuration: ") + fault);
  };
  demand(config.max_regions >= 1, "max_regions must be at least 1");
  demand(config.stop_ratio >= 0 && config.stop_ratio <= 1, "stop_ratio must be within 0 and 1");
  demand(config.box_side >= 2, "box_side must be at least 2");
  demand(config.inhibition_radius > 0, "inhibition_radius must be above 0");
}

// The first of the largest samples in raster order.
Peak highest(const Plane<double>& map) {
  const auto samples = map.samples();
  const auto index = static_cast<int>(std::max_element(samples.begin(), samples.end()) - samples.begin());
  return {index % map.width(), index / map.width(), samples[static_cast<std::size_t>(index)]};
}

// What is left of the saliency at squared distance d2 from a peak: all or nothing for the disk, a smooth dip
// for the Gaussian.
double remaining(double d2, const RegionConfig& config) {
  const double r2 = config.inhibition_radius * config.inhibition_radius;
  if (config.inhibition == Inhibition::disk) return d2 <= r2 ? 0 : 1;
  return -std::expm1(-d2 / (2 * r2));
}

void inhibit(Plane<double>& map, const Peak& peak, const RegionConfig& config) {
  if (config.inhibition == Inhibition::box) {
    const Box box = region_box(peak, config.box_side, map.width(), map.height());
    for (int y = box.y0; y < box.y1; ++y) {
      for (int x = box.x0; x < box.x1; ++x) map(x, y) = 0;
    }
    return;
  }
  // Nine sigma away a Gaussian dip is below the last bit of a double.
  const double reach =
      config.inhibition == Inhibition::disk ? config.inhibition_radius : 9 * config.inhibition_radius;
  const int r = static_cast<int>(std::min(std::ceil(reach), 1e6));
  for (int y = std::max(0, peak.y - r); y <= std::min(map.height() - 1, peak.y + r); ++y) {
    for (int x = std::max(0, peak.x - r); x <= std::min(map.width() - 1, peak.x + r); ++x) {
      const double dx = x - peak.x;
      const double dy = y - peak.y;
      map(x, y) *= remaining(dx * dx + dy * dy, config);
    }
  }
}

}  // namespace

Box region_box(const Peak& peak, int side, int map_width, int map_height) {
  const int before = side / 2;
  return {std::max(0, peak.x - before), std::max(0, peak.y - before),
          std::min(map_width, peak.x - before + side), std::min(map_height, peak.y - before + side)};
}

std::vector<Peak> find_peaks(const Map& saliency, const RegionConfig& config) {
  check(config);
  Plane<double> map = saliency.values();
  std::vector<Peak> peaks;
  while (static_cast<int>(peaks.size()) < config.max_regions) {
    const Peak peak = highest(map);
    if (peak.saliency <= 0) break;
    if (!peaks.empty() && peak.saliency <= peaks.front().saliency * config.stop_ratio) break;
    peaks.push_back(peak);
    inhibit(map, peak, config);
  }
  return peaks;
}

}  // namespace sailmap
