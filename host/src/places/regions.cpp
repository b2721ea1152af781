// Spec section 8: salient regions by repeated arg-max with inhibition of return.
#include <algorithm>
#include <cmath>
#include <string>

#include "highest.hpp"
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

// What is left of the saliency at squared distance d2 from a peak: all or nothing for the disk, a smooth dip
// for the Gaussian.
double remaining(double d2, const RegionConfig& config) {
  const double r2 = config.inhibition_radius * config.inhibition_radius;
  if (config.inhibition == Inhibition::disk) return d2 <= r2 ? 0 : 1;
  return -std::expm1(-d2 / (2 * r2));
}

// The rows and columns that the inhibition of a peak changes.
Box inhibited_box(const Peak& peak, const RegionConfig& config, int width, int height) {
  if (config.inhibition == Inhibition::box) return region_box(peak, config.box_side, width, height);
  // Nine sigma away a Gaussian dip is below the last bit of a double.
  const double reach =
      config.inhibition == Inhibition::disk ? config.inhibition_radius : 9 * config.inhibition_radius;
  const int r = static_cast<int>(std::min(std::ceil(reach), 1e6));
  return {std::max(0, peak.x - r), std::max(0, peak.y - r), std::min(width, peak.x + r + 1),
          std::min(height, peak.y + r + 1)};
}

template <class T>
void inhibit(Plane<T>& map, const Peak& peak, const Box& box, const RegionConfig& config) {
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      if (config.inhibition == Inhibition::box) {
        map(x, y) = 0;
        continue;
      }
      const double dx = x - peak.x;
      const double dy = y - peak.y;
      map(x, y) = static_cast<T>(map(x, y) * remaining(dx * dx + dy * dy, config));
    }
  }
}

// `lsb`: what a sample of 1 is worth.
template <class T>
std::vector<Peak> peaks_of(Plane<T> map, double lsb, const RegionConfig& config) {
  Highest<T> highest(map);
  std::vector<Peak> peaks;
  peaks.reserve(static_cast<std::size_t>(std::min(config.max_regions, 64)));
  while (static_cast<int>(peaks.size()) < config.max_regions) {
    const auto [x, y] = highest.position();
    const Peak peak{x, y, lsb * static_cast<double>(map(x, y))};
    if (peak.saliency <= 0) break;
    if (!peaks.empty() && peak.saliency <= peaks.front().saliency * config.stop_ratio) break;
    peaks.push_back(peak);
    const Box box = inhibited_box(peak, config, map.width(), map.height());
    inhibit(map, peak, box, config);
    highest.changed(box.y0, box.y1);
  }
  return peaks;
}

}  // namespace

Box region_box(const Peak& peak, int side, int map_width, int map_height) {
  const int before = side / 2;
  return {std::max(0, peak.x - before), std::max(0, peak.y - before),
          std::min(map_width, peak.x - before + side), std::min(map_height, peak.y - before + side)};
}

std::vector<Peak> find_peaks(const Map& saliency, const RegionConfig& config) {
  check(config);
  // A Gaussian dip leaves fractions; otherwise samples stay what they are or become 0.
  if (config.inhibition == Inhibition::gaussian) return peaks_of(saliency.values(), 1, config);
  return std::visit([&](const auto& samples) { return peaks_of(samples, saliency.lsb, config); },
                    saliency.samples);
}

}  // namespace sailmap
