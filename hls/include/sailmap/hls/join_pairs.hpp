// Two pairs of stored maps and their flags (local_maxima.hpp) as the four lanes that a store keeps.
//
// Streams, base level, raster order, conspicuity twice. In: lanes 0 and 1, lanes 2 and 3, and their flags.
// Out: four lanes and their flags, bit l for lane l, and the marks of the first pair. Latency 0. II 1. Exact.
// `Kind` tells the instances apart (see normalise.hpp).
#pragma once

#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/kinds.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

template <class Config, int Kind>
void join_pairs(stream<uint32_t>& low, stream<uint8_t>& low_flags, stream<uint32_t>& high,
                stream<uint8_t>& high_flags, stream<uint64_t>& out, stream<uint8_t>& flags, uint16_t width,
                uint16_t height) {
  const int pixels = (Kind == conspicuity_kind ? passes : 1) * Config::columns(width, geometry::base_level) *
                     Config::rows(height, geometry::base_level);
#pragma nounroll
  for (int i = Kind; i < pixels + Kind; ++i) {
    SAILMAP_PIPELINE
    const uint32_t low_word = low.read();
    const uint32_t high_word = high.read();
    const uint8_t low_bits = low_flags.read();
    const uint8_t high_bits = high_flags.read();
    out.write(wide_pair(low_word, high_word));
    flags.write(static_cast<uint8_t>(low_bits | (high_bits & 3) << 2));
  }
}

}  // namespace hls
}  // namespace sailmap
