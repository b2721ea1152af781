// The whole front end, spec sections 2-7, as one dataflow region of streaming stages.
//
// One frame a call, level-0 size width x height, which Config::takes(). Streams in: red, green and blue,
// Config::beat bytes a word, the left pixel in the low byte, raster order. Out, each in raster order of the
// base level, ceil(width/4) x ceil(height/4):
//   intensity_maps    lanes on, off; raw intensity_feature
//   colour_maps       lanes green, blue, red, yellow; raw colour_feature
//   orientation_maps  lanes 0, 45, 90, 135 degrees; raw orientation_feature
//   conspicuity_maps  lanes C_I, C_C, C_O; raw conspicuity, before their own normalisation
//   saliency          S; raw
//   statistics        26 words: maximum and m of the ten feature maps, then of C_I, C_C, C_O
// A reader that takes one stream after the other may stop the network: read the six side by side, or first
// statistics and feature maps side by side. Latency: the frame, the rows that sum_lag_rows(2) names, a count
// and two replays of the feature maps. Cycles from frame to frame: throughput.hpp.
//
// The region is put together from parts that are the same for every tool (region/*.inc, in the order of their
// numbers): a stage call must stand in the region itself, where no tool has to look through templates or
// inlined functions to find it.
#pragma once

#include "sailmap/hls/across_scales.hpp"
#include "sailmap/hls/centre_surround.hpp"
#include "sailmap/hls/channels.hpp"
#include "sailmap/hls/config.hpp"
#include "sailmap/hls/delay_line.hpp"
#include "sailmap/hls/double_buffer.hpp"
#include "sailmap/hls/gabor.hpp"
#include "sailmap/hls/join_pairs.hpp"
#include "sailmap/hls/local_maxima.hpp"
#include "sailmap/hls/normalise.hpp"
#include "sailmap/hls/peaks.hpp"
#include "sailmap/hls/reduce_lanes.hpp"
#include "sailmap/hls/reduce_pixels.hpp"
#include "sailmap/hls/saliency.hpp"
#include "sailmap/hls/store.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

// The ports of the front end for a beat.
#define SAILMAP_FRONT_END_PORTS(Word)                                                                     \
  stream<Word>&red, stream<Word>&green, stream<Word>&blue, stream<uint32_t>&intensity_maps,               \
      stream<uint64_t>&colour_maps, stream<uint64_t>&orientation_maps, stream<uint64_t>&conspicuity_maps, \
      stream<uint16_t>&saliency, stream<uint32_t>&statistics, uint16_t width, uint16_t height

template <class Config, int Beat = Config::beat, bool DoubleBuffer = Config::double_buffer>
struct FrontEnd;

template <class Config>
struct FrontEnd<Config, 1, false> {
  static void run(SAILMAP_FRONT_END_PORTS(uint8_t)) {
#pragma HLS dataflow
#include "sailmap/hls/region/1_to_base_1.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_once.inc"
  }
};

template <class Config>
struct FrontEnd<Config, 1, true> {
  static void run(SAILMAP_FRONT_END_PORTS(uint8_t)) {
#pragma HLS dataflow
#include "sailmap/hls/region/1_to_base_1.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_twice.inc"
  }
};

template <class Config>
struct FrontEnd<Config, 2, false> {
  static void run(SAILMAP_FRONT_END_PORTS(uint16_t)) {
#pragma HLS dataflow
#include "sailmap/hls/region/1_to_base_2.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_once.inc"
  }
};

template <class Config>
struct FrontEnd<Config, 2, true> {
  static void run(SAILMAP_FRONT_END_PORTS(uint16_t)) {
#pragma HLS dataflow
#include "sailmap/hls/region/1_to_base_2.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_twice.inc"
  }
};

template <class Config>
struct FrontEnd<Config, 4, false> {
  static void run(SAILMAP_FRONT_END_PORTS(uint32_t)) {
#pragma HLS dataflow
#include "sailmap/hls/region/1_to_base_4.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_once.inc"
  }
};

template <class Config>
struct FrontEnd<Config, 4, true> {
  static void run(SAILMAP_FRONT_END_PORTS(uint32_t)) {
#pragma HLS dataflow
#include "sailmap/hls/region/1_to_base_4.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_twice.inc"
  }
};

template <class Config>
struct FrontEnd<Config, 8, false> {
  static void run(SAILMAP_FRONT_END_PORTS(uint64_t)) {
#pragma HLS dataflow
#include "sailmap/hls/region/1_to_base_8.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_once.inc"
  }
};

template <class Config>
struct FrontEnd<Config, 8, true> {
  static void run(SAILMAP_FRONT_END_PORTS(uint64_t)) {
#pragma HLS dataflow
#include "sailmap/hls/region/1_to_base_8.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_twice.inc"
  }
};

}  // namespace hls
}  // namespace sailmap
