// The front end between memory and memory, as one dataflow region and the report around it: what a device of
// Vitis (Alveo, Kria) is linked with, and what a bare-metal system drives without a DMA engine of its own.
//
// Ports: memory_registers.h says what lies where. Each port is read or written by one stage, in one burst a
// frame, and has an AXI master of its own. A size that Config does not take is refused: nothing is read, and
// nothing written but the report. Latency and II: those of the front end (front_end.hpp), as long as memory
// takes a word of every port and gives a beat of pixels a cycle.
#pragma once

#include <ap_int.h>

#include "sailmap/hls/front_end.hpp"
#include "sailmap/hls/memory_registers.h"
#include "sailmap/hls/saliency.hpp"

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

// A map, or the lanes of several, to memory. Port tells the instances apart.
template <class Config, int Port, class Word>
void map_to_memory(stream<Word>& in, Word* out, uint16_t width, uint16_t height) {
  const int words = geometry::base_side(width) * geometry::base_side(height);
  for (int i = 0; i < words; ++i) {
    SAILMAP_PIPELINE
    out[i] = in.read();
  }
}
template <class Config>
void statistics_to_memory(stream<uint32_t>& in, uint32_t* out) {
  for (int i = 0; i < statistics_words; ++i) {
    SAILMAP_PIPELINE
    out[i] = in.read();
  }
}
static_assert(statistics_words == SAILMAP_STATISTICS_WORDS, "the shared header says how many there are");

#define SAILMAP_MEMORY_PORTS                                                                       \
  const memory_beat<Config::beat>*pixels, uint32_t *intensity_maps_out, uint64_t *colour_maps_out, \
      uint64_t *orientation_maps_out, uint64_t *conspicuity_maps_out, uint16_t *saliency_out,      \
      uint32_t *statistics_out, uint16_t width, uint16_t height

template <class Config, int Beat = Config::beat, bool DoubleBuffer = Config::double_buffer>
struct MemoryRegion;

template <class Config>
struct MemoryRegion<Config, 1, false> {
  static void run(SAILMAP_MEMORY_PORTS) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_pixels_in.inc"
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/1_to_base_1.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_once.inc"
#include "sailmap/hls/region/4_maps_to_memory.inc"
  }
};

template <class Config>
struct MemoryRegion<Config, 1, true> {
  static void run(SAILMAP_MEMORY_PORTS) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_pixels_in.inc"
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/1_to_base_1.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_twice.inc"
#include "sailmap/hls/region/4_maps_to_memory.inc"
  }
};

template <class Config>
struct MemoryRegion<Config, 2, false> {
  static void run(SAILMAP_MEMORY_PORTS) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_pixels_in.inc"
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/1_to_base_2.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_once.inc"
#include "sailmap/hls/region/4_maps_to_memory.inc"
  }
};

template <class Config>
struct MemoryRegion<Config, 2, true> {
  static void run(SAILMAP_MEMORY_PORTS) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_pixels_in.inc"
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/1_to_base_2.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_twice.inc"
#include "sailmap/hls/region/4_maps_to_memory.inc"
  }
};

template <class Config>
struct MemoryRegion<Config, 4, false> {
  static void run(SAILMAP_MEMORY_PORTS) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_pixels_in.inc"
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/1_to_base_4.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_once.inc"
#include "sailmap/hls/region/4_maps_to_memory.inc"
  }
};

template <class Config>
struct MemoryRegion<Config, 4, true> {
  static void run(SAILMAP_MEMORY_PORTS) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_pixels_in.inc"
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/1_to_base_4.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_twice.inc"
#include "sailmap/hls/region/4_maps_to_memory.inc"
  }
};

template <class Config>
struct MemoryRegion<Config, 8, false> {
  static void run(SAILMAP_MEMORY_PORTS) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_pixels_in.inc"
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/1_to_base_8.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_once.inc"
#include "sailmap/hls/region/4_maps_to_memory.inc"
  }
};

template <class Config>
struct MemoryRegion<Config, 8, true> {
  static void run(SAILMAP_MEMORY_PORTS) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_pixels_in.inc"
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/1_to_base_8.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_twice.inc"
#include "sailmap/hls/region/4_maps_to_memory.inc"
  }
};

// What the kernel says of itself and of this start; all but the status.
template <class Config>
inline void report_out(uint32_t* report, uint32_t width, uint32_t height, uint32_t frame, bool taken) {
  const uint32_t words[SAILMAP_REPORT_WORDS] = {
      SAILMAP_MEMORY_VERSION,
      Config::max_width,
      Config::max_height,
      Config::beat,
      geometry::min_image_side,
      width,
      height,
      frame,
      taken ? static_cast<uint32_t>(geometry::base_side(static_cast<int>(width)) *
                                    geometry::base_side(static_cast<int>(height)))
            : 0,
      SAILMAP_STATUS_BUSY};
  for (int i = 0; i < SAILMAP_REPORT_WORDS; ++i) {
    SAILMAP_PIPELINE
    report[i] = words[i];
  }
}

template <class Config>
inline void memory_front_end(const memory_beat<Config::beat>* pixels, uint32_t* intensity_maps_out,
                             uint64_t* colour_maps_out, uint64_t* orientation_maps_out,
                             uint64_t* conspicuity_maps_out, uint16_t* saliency_out, uint32_t* statistics_out,
                             uint32_t* report, uint32_t width, uint32_t height, uint32_t frame) {
  const bool taken = width <= Config::max_width && height <= Config::max_height &&
                     Config::takes(static_cast<int>(width), static_cast<int>(height));
  report_out<Config>(report, width, height, frame, taken);
  if (!taken) {
    report[SAILMAP_REPORT_STATUS] = SAILMAP_STATUS_REFUSED;
    return;
  }
  MemoryRegion<Config>::run(pixels, intensity_maps_out, colour_maps_out, orientation_maps_out,
                            conspicuity_maps_out, saliency_out, statistics_out, static_cast<uint16_t>(width),
                            static_cast<uint16_t>(height));
  report[SAILMAP_REPORT_STATUS] = SAILMAP_STATUS_DONE;
}

}  // namespace hls
}  // namespace sailmap
