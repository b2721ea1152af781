// Spec section 4: centre-surround contrast of one level of one channel, summed over both radii.
#pragma once

#include <cstdint>

#include "padded_plane.hpp"
#include "samples.hpp"

namespace sailmap::fixed {

// Contrasts, raw intensity_contrast or colour_contrast.
using ContrastPlane = PaddedPlane<std::int32_t>;

class CentreSurround {
 public:
  // `level` has its edges replicated by at least 8 samples. `off` may be null.
  void compute(const PaddedPlane<Sample>& level, ContrastPlane& on, ContrastPlane* off);

  // Rows of the table of sums that one row of contrasts looks at, modulo which they are held.
  static constexpr int rows = 16;

 private:
  PaddedPlane<std::uint32_t> sums_;
};

}  // namespace sailmap::fixed
