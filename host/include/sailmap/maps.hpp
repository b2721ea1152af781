// What a front end computes of one image: feature maps, conspicuity maps and the saliency map.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "sailmap/hls/geometry.hpp"
#include "sailmap/ref/normalise.hpp"
#include "sailmap/ref/plane.hpp"

namespace sailmap {

inline constexpr std::size_t feature_count = hls::geometry::feature_maps;
inline constexpr std::size_t conspicuity_count = hls::geometry::conspicuity_maps;

// Spec section 6: the order of the feature maps everywhere.
inline constexpr std::array<std::string_view, feature_count> feature_names = {
    "intensity_on", "intensity_off", "green",  "blue",   "red",
    "yellow",       "ori_0",         "ori_45", "ori_90", "ori_135"};
inline constexpr std::array<std::string_view, conspicuity_count> conspicuity_names = {
    "conspicuity_intensity", "conspicuity_colour", "conspicuity_orientation"};

// Which conspicuity map (0 intensity, 1 colour, 2 orientation) a feature map belongs to.
inline constexpr std::array<std::size_t, feature_count> kind_of_feature = {0, 0, 1, 1, 1, 1, 2, 2, 2, 2};

// Half-open box of base-level pixels [x0, x1) x [y0, y1).
struct Box {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  [[nodiscard]] int area() const { return (x1 - x0) * (y1 - y0); }
  bool operator==(const Box&) const = default;
};

// One map of base-level size. Reference maps hold doubles in the spec's units; those of the fixed-point front
// ends hold raw integers, worth `lsb` of the spec's units each, in the number format named `format`.
struct Map {
  std::variant<Plane<double>, Plane<std::uint16_t>, Plane<std::uint32_t>> samples;
  double lsb = 1;
  std::string format = "float64";

  [[nodiscard]] int width() const;
  [[nodiscard]] int height() const;
  // In the spec's units.
  [[nodiscard]] double at(int x, int y) const;
  // The mean over a box of at least one pixel inside the map, in the spec's units.
  [[nodiscard]] double mean(const Box& box) const;
  // All samples in the spec's units.
  [[nodiscard]] Plane<double> values() const;
};

// Everything a front end says about one image. All maps are ceil(W/4) x ceil(H/4).
struct Maps {
  // Whether there are none: a front end's hardware kept them to itself.
  [[nodiscard]] bool empty() const { return image_width == 0; }

  int image_width = 0;  // level-0 pixels
  int image_height = 0;
  std::array<Map, feature_count> features;  // before normalisation (spec 6)
  std::array<MapStatistics, feature_count> feature_statistics;
  std::array<Map, conspicuity_count> conspicuities;  // before their own normalisation (spec 7)
  std::array<MapStatistics, conspicuity_count> conspicuity_statistics;
  Map saliency;
};

}  // namespace sailmap
