// Spec section 5: Gabor energy of one level of the intensity in four orientations.
#pragma once

#include <array>
#include <cstdint>

#include "padded_plane.hpp"
#include "sailmap/hls/geometry.hpp"
#include "samples.hpp"

namespace sailmap::fixed {

// Raw gabor_energy.
using EnergyPlane = PaddedPlane<std::int32_t>;

class Orientation {
 public:
  // `level` has its edges replicated by at least 16 samples. energies[i]: theta = 45 degrees x i.
  void compute(const PaddedPlane<Sample>& level,
               const std::array<EnergyPlane*, hls::geometry::orientation_maps>& energies);

  // The vertical filters, one row of `columns` each.
  enum Filter { even, odd, cosine, sine, gauss };
  static constexpr int filters = 5;

 private:
  PaddedPlane<std::int16_t> columns_;
};

}  // namespace sailmap::fixed
