// Spec section 6: the maps of levels 4, 3 and 2 become one feature map of the base level.
#pragma once

#include <array>
#include <cstdint>

#include "padded_plane.hpp"
#include "sailmap/hls/geometry.hpp"

namespace sailmap::fixed {

// Exact sums of base-level size, raw; -1 around it, below all of them.
using SumPlane = PaddedPlane<std::int32_t>;
inline SumPlane make_sum_plane() { return SumPlane(1, -1); }

class AcrossScales {
 public:
  // `levels`: contrasts or energies, finest first; those above the base level are changed. `sums`: the exact
  // sums; `feature`: the map, unpadded. Intensity, colour and orientation have the same raw numbers. Returns
  // the largest sum.
  std::int32_t compute(std::array<PaddedPlane<std::int32_t>, hls::geometry::map_levels>& levels,
                       SumPlane& sums, std::uint16_t* feature);

 private:
  PaddedPlane<std::int32_t> row_;  // of the coarser level, interpolated
};

}  // namespace sailmap::fixed
