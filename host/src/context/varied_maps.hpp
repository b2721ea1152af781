// Maps that are the same throughout, as the colours of grey images, say nothing: only the others are
// compared.
#pragma once

#include <bit>
#include <cmath>

#include "sailmap/maps.hpp"

namespace sailmap::context {

inline constexpr unsigned all_maps = (1U << feature_count) - 1;

// How many maps say something, a bit for each. Nearly always all, and counting takes long without an
// instruction for it.
inline int maps_in(unsigned varied) {
  return varied == all_maps ? int{feature_count} : std::popcount(varied);
}

// What a sum over the maps that say something in both is divided by, given how many say something in each. A
// map that says something in one only thus counts against the match: the correlation of signs.
inline float mean_of_maps(int a, int b) {
  return a == b ? static_cast<float>(a) : std::sqrt(static_cast<float>(a * b));
}

}  // namespace sailmap::context
