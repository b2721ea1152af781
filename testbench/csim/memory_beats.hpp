// A frame in memory, as the kernels between memory and memory read it.
#pragma once

#include <cstddef>
#include <vector>

#include "sailmap/csim/frame.hpp"
#include "sailmap/hls/memory_kernel.hpp"

namespace sailmap::testing {

// The byte of a pixel that is ignored is neither 0 nor 255.
template <int Beat>
std::vector<hls::memory_beat<Beat>> memory_beats(const csim::Frame& frame) {
  std::vector<hls::memory_beat<Beat>> beats(frame.rgb.size() / 3 / Beat);
  for (std::size_t i = 0; i < frame.rgb.size() / 3; ++i) {
    hls::memory_beat<Beat>& beat = beats[i / Beat];
    for (int bit = 0; bit < 32; ++bit) {
      const unsigned byte = bit < 24 ? frame.rgb[3 * i + static_cast<std::size_t>(bit / 8)] : 0xc3U;
      beat.set(32 * static_cast<int>(i % Beat) + bit, (byte >> (bit % 8) & 1U) != 0);
    }
  }
  return beats;
}

}  // namespace sailmap::testing
