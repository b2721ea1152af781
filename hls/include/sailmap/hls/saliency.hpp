// Plumbing around the conspicuity maps (spec 7): the three kinds as pairs.
#pragma once

#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/kinds.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

// The exact sums of C_I, C_C and C_O of a pixel as pairs, the second C_O and 0. Base level, raster order,
// twice; latency 0, II 1, exact.
template <class Config>
void pair_conspicuities(stream<uint32_t>& intensity, stream<uint32_t>& colour, stream<uint32_t>& orientation,
                        stream<uint64_t>& intensity_colour, stream<uint64_t>& orientation_alone,
                        uint16_t width, uint16_t height) {
  const int pixels =
      passes * Config::columns(width, geometry::base_level) * Config::rows(height, geometry::base_level);
#pragma nounroll
  for (int i = 0; i < pixels; ++i) {
    SAILMAP_PIPELINE
    const uint32_t i_word = intensity.read();
    const uint32_t c_word = colour.read();
    const uint32_t o_word = orientation.read();
    intensity_colour.write(wide_pair(i_word, c_word));
    orientation_alone.write(wide_pair(o_word, 0));
  }
}

}  // namespace hls
}  // namespace sailmap
