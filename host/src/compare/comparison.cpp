#include "sailmap/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "sailmap/error.hpp"

namespace sailmap {
namespace {

constexpr int compared_regions = 5;

template <class SomeMaps>
auto& at(SomeMaps& maps, std::size_t index) {
  if (index < feature_count) return maps.features[index];
  if (index < feature_count + conspicuity_count) return maps.conspicuities[index - feature_count];
  return maps.saliency;
}

MapDifference compare_map(const Map& tested, const Map& expected) {
  const Plane<double> a = tested.values();
  const Plane<double> b = expected.values();
  MapDifference out;
  double squares = 0;
  for (std::size_t i = 0; i < b.samples().size(); ++i) {
    const double difference = std::abs(a.samples()[i] - b.samples()[i]);
    out.largest = std::max(out.largest, difference);
    out.expected_maximum = std::max(out.expected_maximum, b.samples()[i]);
    squares += difference * difference;
  }
  out.mean_square = squares / static_cast<double>(b.samples().size());
  out.lsb = std::holds_alternative<Plane<double>>(tested.samples) ? 0 : tested.lsb;
  return out;
}

// Peaks among `others` at most `reach` pixels away from `peak` in x and y.
bool has_near(const std::vector<Peak>& others, const Peak& peak, int reach) {
  return std::any_of(others.begin(), others.end(), [&](const Peak& other) {
    return std::abs(other.x - peak.x) <= reach && std::abs(other.y - peak.y) <= reach;
  });
}

void compare_regions(const Maps& tested, const Maps& expected, RegionConfig config, ImageDifference& out) {
  config.max_regions = std::min(config.max_regions, compared_regions);
  const std::vector<Peak> found = find_peaks(tested.saliency, config);
  for (const Peak& peak : find_peaks(expected.saliency, config)) {
    ++out.regions;
    out.same_regions += has_near(found, peak, 0) ? 1 : 0;
    out.near_regions += has_near(found, peak, 1) ? 1 : 0;
  }
}

void check_same_size(const Maps& tested, const Maps& expected) {
  if (tested.image_width != expected.image_width || tested.image_height != expected.image_height) {
    throw Error("maps of images of different size cannot be compared");
  }
}

// The image that made a node, and so names the place in both maps.
int maker(const TopologicalMap& map, int node) {
  return map.nodes()[static_cast<std::size_t>(node)].views.front().image;
}

}  // namespace

const Map& map_at(const Maps& maps, std::size_t index) { return at(maps, index); }

Map& map_at(Maps& maps, std::size_t index) { return at(maps, index); }

std::string_view map_name(std::size_t index) {
  if (index < feature_count) return feature_names[index];
  if (index < feature_count + conspicuity_count) return conspicuity_names[index - feature_count];
  return "saliency";
}

double MapDifference::largest_share() const { return expected_maximum > 0 ? largest / expected_maximum : 0; }

double MapDifference::rms_share() const {
  return expected_maximum > 0 ? std::sqrt(mean_square) / expected_maximum : 0;
}

ImageDifference compare_maps(const Maps& tested, const Maps& expected, const RegionConfig& regions) {
  check_same_size(tested, expected);
  ImageDifference out;
  for (std::size_t i = 0; i < map_count; ++i) {
    out.maps[i] = compare_map(map_at(tested, i), map_at(expected, i));
  }
  for (std::size_t i = 0; i < feature_count; ++i) {
    const bool same = tested.feature_statistics[i].maxima == expected.feature_statistics[i].maxima;
    out.maps_of_other_m += same ? 0 : 1;
  }
  for (std::size_t i = 0; i < conspicuity_count; ++i) {
    const bool same = tested.conspicuity_statistics[i].maxima == expected.conspicuity_statistics[i].maxima;
    out.maps_of_other_m += same ? 0 : 1;
  }
  compare_regions(tested, expected, regions, out);
  return out;
}

Maps difference_maps(const Maps& tested, const Maps& expected) {
  check_same_size(tested, expected);
  Maps out;
  out.image_width = expected.image_width;
  out.image_height = expected.image_height;
  for (std::size_t i = 0; i < map_count; ++i) {
    Plane<double> difference = map_at(tested, i).values();
    const Plane<double> b = map_at(expected, i).values();
    for (std::size_t k = 0; k < b.samples().size(); ++k) {
      difference.samples()[k] = std::abs(difference.samples()[k] - b.samples()[k]);
    }
    const double largest = std::ranges::max(difference.samples());
    if (i < feature_count) {
      out.feature_statistics[i].maximum = largest;
    } else if (i < feature_count + conspicuity_count) {
      out.conspicuity_statistics[i - feature_count].maximum = largest;
    }
    map_at(out, i).samples = std::move(difference);
  }
  return out;
}

LoopAgreement compare_loops(const TopologicalMap& tested, const TopologicalMap& expected) {
  if (tested.images() != expected.images()) throw Error("maps of different sequences cannot be compared");
  LoopAgreement out;
  out.images = expected.images();
  out.tested_loops = tested.loops();
  out.expected_loops = expected.loops();
  for (std::size_t i = 0; i < expected.history().size(); ++i) {
    const Detection& a = tested.history()[i].detection;
    const Detection& b = expected.history()[i].detection;
    out.same_verdict += a.accepted() == b.accepted() ? 1 : 0;
    if (a.best.node < 0 || b.best.node < 0) continue;
    ++out.with_best;
    out.same_best += maker(tested, a.best.node) == maker(expected, b.best.node) ? 1 : 0;
  }
  return out;
}

}  // namespace sailmap
