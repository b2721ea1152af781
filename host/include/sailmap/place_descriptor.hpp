// What the method `context` keeps of an image: its coarse layout and the surroundings of its salient regions,
// as bits read from the ten feature maps that any front end gives.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sailmap/maps.hpp"

namespace sailmap {

// The image as 16 x 12 cells: one bit a cell and map, set where the map is above its mean in the 5 x 5 cells
// around; a map that is the same throughout has none. A column is two words: bit 10 * row + map of the 128,
// so that a shift by a row is a shift by ten bits.
struct Layout {
  static constexpr int columns = 16;
  static constexpr int rows = 12;
  std::array<std::array<std::uint64_t, 2>, columns> words{};
  bool operator==(const Layout&) const = default;
};

// A salient region with its context: of each map one bit for each of 8 x 8 cells around it (10/32 of the
// image's width by 10/24 of its height), set where the map is above its mean in the context.
struct ContextRegion {
  static constexpr int side = 8;
  // Position in parts of the image's size, 0 .. 65535: images of different size can be compared.
  std::uint16_t x = 0;
  std::uint16_t y = 0;
  std::uint16_t varied = 0;  // bit i: map i is not the same throughout the context, and so says something
  std::array<std::uint64_t, feature_count> bits{};
  bool operator==(const ContextRegion&) const = default;
};

struct PlaceDescriptor {
  static constexpr int max_regions = 85;
  Layout layout;
  std::vector<ContextRegion> regions;  // by falling saliency, at most max_regions; none in a flat image
  bool operator==(const PlaceDescriptor&) const = default;
};

// Of any front end's maps; only ratios within a map count, not its unit.
PlaceDescriptor describe_place(const Maps& maps);

// Hexadecimal digits, for files. from_text throws Error when the text is not what to_text wrote.
std::string to_text(const PlaceDescriptor& place);
PlaceDescriptor place_from_text(const std::string& text);

}  // namespace sailmap
