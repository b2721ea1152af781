// One front end held against another: how far the maps are apart, and what that does to regions and loops.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "sailmap/maps.hpp"
#include "sailmap/signature.hpp"
#include "sailmap/topological_map.hpp"

namespace sailmap {

inline constexpr std::size_t map_count = feature_count + conspicuity_count + 1;

// Features, conspicuities, saliency, in this order.
const Map& map_at(const Maps& maps, std::size_t index);
Map& map_at(Maps& maps, std::size_t index);
std::string_view map_name(std::size_t index);

// |tested - expected| of one map of one image, in the spec's units.
struct MapDifference {
  double expected_maximum = 0;  // of the expected map
  double largest = 0;
  double mean_square = 0;
  double lsb = 0;  // of the tested map; 0 when it has none (floating point)

  // Parts of the expected map's maximum; 0 for a flat map.
  [[nodiscard]] double largest_share() const;
  [[nodiscard]] double rms_share() const;
};

struct ImageDifference {
  std::array<MapDifference, map_count> maps;
  // Feature and conspicuity maps whose m (eq. 1) differs: a peak at half the maximum counts in one and not in
  // the other, and the map is then scaled otherwise.
  int maps_of_other_m = 0;
  int regions = 0;       // of the expected five most salient ones ...
  int same_regions = 0;  // ... those among the tested five at the same base-level pixel
  int near_regions = 0;  // ... at most one base-level pixel away in x and y
};

// Both of the same image. Throws Error when their sizes differ.
ImageDifference compare_maps(const Maps& tested, const Maps& expected, const RegionConfig& regions);

// |tested - expected| of every map, as maps; statistics hold the largest difference and no m.
Maps difference_maps(const Maps& tested, const Maps& expected);

// Two maps built of the same images: how often they say the same.
struct LoopAgreement {
  int images = 0;
  int same_verdict = 0;  // both close a loop, or neither does
  int same_best =
      0;  // of the images that have a best node in both, those whose best node was made by the same image
  int with_best = 0;
  int tested_loops = 0;
  int expected_loops = 0;
};

LoopAgreement compare_loops(const TopologicalMap& tested, const TopologicalMap& expected);

}  // namespace sailmap
