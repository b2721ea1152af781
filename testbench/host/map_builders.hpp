// Small signatures and maps that tests are made of.
#pragma once

#include <utility>
#include <vector>

#include "sailmap/signature.hpp"
#include "sailmap/topological_map.hpp"

namespace sailmap::testing {

// A descriptor that is `value` in its first entry and 0 elsewhere: distances are differences of values.
inline Descriptor level(double value) {
  Descriptor v{};
  v[0] = static_cast<float>(value);
  return v;
}

inline Region region(int x, int y, double value, double saliency = 1) {
  return {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), static_cast<float>(saliency),
          level(value)};
}

// Of a 300 x 400 image, whose diagonal is 500 pixels.
inline Signature signature(std::vector<Region> regions) { return {300, 400, std::move(regions)}; }

// An image of place `place`: the similarity of two images of one place is the cap, of different ones small.
inline Signature image_of_place(int place) {
  return signature(
      {region(100, 100, 3.0 * place), region(200, 100, 3.0 * place + 1), region(200, 300, 3.0 * place + 2)});
}

inline MapConfig small_map_config() {
  MapConfig config;
  config.exclude_recent = 2;
  config.detection.same_place_nodes = 0;
  return config;
}

// Adds an image of each place in turn.
inline TopologicalMap map_of(const std::vector<int>& places, MapConfig config = small_map_config()) {
  TopologicalMap map(config);
  for (std::size_t i = 0; i < places.size(); ++i)
    map.add("image" + std::to_string(i), image_of_place(places[i]));
  return map;
}

}  // namespace sailmap::testing
