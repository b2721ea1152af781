// What the kernels between memory and memory share (memory_front_end.hpp, signature_memory.hpp): a frame from
// memory, the sizes that they take, and the report of a start (memory_registers.h).
#pragma once

#include <ap_int.h>

#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/memory_registers.h"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

// Beat pixels of 32 bits, the left one lowest: R, G, B and nothing from low to high byte.
template <int Beat>
using memory_beat = ap_uint<8 * SAILMAP_PIXEL_BYTES * Beat>;

// Byte `Component` (0 red, 1 green, 2 blue) of each pixel of a beat.
template <int Beat, int Component>
inline bytes_t<Beat> memory_component(const memory_beat<Beat>& beat) {
  uint64_t word = 0;
  for (int i = 0; i < Beat; ++i) {
    const int low = 8 * (SAILMAP_PIXEL_BYTES * i + Component);
    const uint64_t byte = beat.range(low + 7, low).to_uint();
    word |= byte << (8 * i);
  }
  return static_cast<bytes_t<Beat> >(word);
}

// A frame from memory.
template <class Config>
void pixels_in(const memory_beat<Config::beat>* pixels, stream<bytes_t<Config::beat> >& red,
               stream<bytes_t<Config::beat> >& green, stream<bytes_t<Config::beat> >& blue, uint16_t width,
               uint16_t height) {
  const int beats = width / Config::beat * height;
  for (int i = 0; i < beats; ++i) {
    SAILMAP_PIPELINE
    const memory_beat<Config::beat> beat = pixels[i];
    red.write(memory_component<Config::beat, 0>(beat));
    green.write(memory_component<Config::beat, 1>(beat));
    blue.write(memory_component<Config::beat, 2>(beat));
  }
}

// A stream of `Words` words a frame to memory.
template <class Config, int Words>
void words_to_memory(stream<uint32_t>& in, uint32_t* out) {
  for (int i = 0; i < Words; ++i) {
    SAILMAP_PIPELINE
    out[i] = in.read();
  }
}

// Whether Config takes a frame of this size; of any numbers that a register may hold.
template <class Config>
inline bool takes_frame(uint32_t width, uint32_t height) {
  return width <= Config::max_width && height <= Config::max_height &&
         Config::takes(static_cast<int>(width), static_cast<int>(height));
}

// What a kernel says of itself and of this start; all but the status. `version` names its interface,
// `output_words` are those of each output of the frame, 0 of a size that is refused.
template <class Config>
inline void report_out(uint32_t* report, uint32_t version, uint32_t width, uint32_t height, uint32_t frame,
                       uint32_t output_words) {
  const uint32_t words[SAILMAP_REPORT_WORDS] = {
      version, Config::max_width, Config::max_height, Config::beat, geometry::min_image_side, width, height,
      frame,   output_words,      SAILMAP_STATUS_BUSY};
  for (int i = 0; i < SAILMAP_REPORT_WORDS; ++i) {
    SAILMAP_PIPELINE
    report[i] = words[i];
  }
}

}  // namespace hls
}  // namespace sailmap
