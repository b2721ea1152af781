// Maps that are the same throughout say nothing: only the others are compared.
#pragma once

#include <bit>
#include <cmath>

#include "sailmap/place_descriptor.hpp"

namespace sailmap::context {

inline constexpr unsigned all_maps = (1U << feature_count) - 1;

// The maps that say something in an image, a bit for each: those that have a bit in its layout.
unsigned varied_maps(const Layout& layout);

// The maps that can be compared between images whose varied maps are these: all, but for the colours where
// one of the images is grey. That it has none is the camera's doing, or the light's, and no sign of another
// place.
unsigned comparable_maps(unsigned varied, unsigned varied_of_other);

// How many maps a set has. Nearly always all, and counting takes long without an instruction for it.
inline int maps_in(unsigned maps) { return maps == all_maps ? int{feature_count} : std::popcount(maps); }

// What a sum over the maps that say something in both is divided by, given how many say something in each. A
// map that says something in one only thus counts against the match: the correlation of signs.
inline float mean_of_maps(int a, int b) {
  return a == b ? static_cast<float>(a) : std::sqrt(static_cast<float>(a * b));
}

}  // namespace sailmap::context
