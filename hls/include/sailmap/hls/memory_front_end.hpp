// The front end between memory and memory, as one dataflow region and the report around it: what a device of
// Vitis (Alveo, Kria) is linked with, and what a bare-metal system drives without a DMA engine of its own.
//
// Ports: memory_registers.h says what lies where. Each port is read or written by one stage, in one burst a
// frame, and has an AXI master of its own. A size that Config does not take is refused: nothing is read, and
// nothing written but the report. Latency and II: those of the front end (front_end.hpp), as long as memory
// takes a word of every port and gives a beat of pixels a cycle.
#pragma once

#include "sailmap/hls/front_end.hpp"
#include "sailmap/hls/memory_kernel.hpp"
#include "sailmap/hls/memory_registers.h"
#include "sailmap/hls/saliency.hpp"

namespace sailmap {
namespace hls {

// A map, or the lanes of several, to memory. Port tells the instances apart.
template <class Config, int Port, class Word>
void map_to_memory(stream<Word>& in, Word* out, uint16_t width, uint16_t height) {
  const int words = geometry::base_side(width) * geometry::base_side(height);
  for (int i = 0; i < words; ++i) {
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
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/0_pixels_in.inc"
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
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/0_pixels_in.inc"
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
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/0_pixels_in.inc"
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
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/0_pixels_in.inc"
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
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/0_pixels_in.inc"
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
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/0_pixels_in.inc"
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
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/0_pixels_in.inc"
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
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/0_pixels_in.inc"
#include "sailmap/hls/region/1_to_base_8.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_twice.inc"
#include "sailmap/hls/region/4_maps_to_memory.inc"
  }
};

template <class Config>
inline void memory_front_end(const memory_beat<Config::beat>* pixels, uint32_t* intensity_maps_out,
                             uint64_t* colour_maps_out, uint64_t* orientation_maps_out,
                             uint64_t* conspicuity_maps_out, uint16_t* saliency_out, uint32_t* statistics_out,
                             uint32_t* report, uint32_t width, uint32_t height, uint32_t frame) {
  if (!takes_frame<Config>(width, height)) {
    report_out<Config>(report, SAILMAP_MEMORY_VERSION, width, height, frame, 0);
    report[SAILMAP_REPORT_STATUS] = SAILMAP_STATUS_REFUSED;
    return;
  }
  report_out<Config>(report, SAILMAP_MEMORY_VERSION, width, height, frame,
                     static_cast<uint32_t>(geometry::base_side(static_cast<int>(width)) *
                                           geometry::base_side(static_cast<int>(height))));
  MemoryRegion<Config>::run(pixels, intensity_maps_out, colour_maps_out, orientation_maps_out,
                            conspicuity_maps_out, saliency_out, statistics_out, static_cast<uint16_t>(width),
                            static_cast<uint16_t>(height));
  report[SAILMAP_REPORT_STATUS] = SAILMAP_STATUS_DONE;
}

}  // namespace hls
}  // namespace sailmap
