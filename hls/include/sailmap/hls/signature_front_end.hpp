// The front end and the signature, spec sections 2-8, as one dataflow region: pixels in, a packed record out,
// no map leaves the chip.
//
// Streams in: those of front_end.hpp. Out: `record`; it and the parameters are those of signature.hpp. One
// frame a call. II: throughput::frame_with_signature().
#pragma once

#include "sailmap/hls/front_end.hpp"
#include "sailmap/hls/signature.hpp"

namespace sailmap {
namespace hls {

#define SAILMAP_SIGNATURE_PORTS(Word)                                                               \
  stream<Word>&red, stream<Word>&green, stream<Word>&blue, stream<uint32_t>&record, uint16_t width, \
      uint16_t height, uint16_t max_regions, uint32_t stop_ratio, uint16_t box_side

template <class Config, int Beat = Config::beat, bool DoubleBuffer = Config::double_buffer>
struct SignatureFrontEnd;

template <class Config>
struct SignatureFrontEnd<Config, 1, false> {
  static void run(SAILMAP_SIGNATURE_PORTS(uint8_t)) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/1_to_base_1.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_once.inc"
#include "sailmap/hls/region/4_signature.inc"
  }
};

template <class Config>
struct SignatureFrontEnd<Config, 1, true> {
  static void run(SAILMAP_SIGNATURE_PORTS(uint8_t)) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/1_to_base_1.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_twice.inc"
#include "sailmap/hls/region/4_signature.inc"
  }
};

template <class Config>
struct SignatureFrontEnd<Config, 2, false> {
  static void run(SAILMAP_SIGNATURE_PORTS(uint16_t)) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/1_to_base_2.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_once.inc"
#include "sailmap/hls/region/4_signature.inc"
  }
};

template <class Config>
struct SignatureFrontEnd<Config, 2, true> {
  static void run(SAILMAP_SIGNATURE_PORTS(uint16_t)) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/1_to_base_2.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_twice.inc"
#include "sailmap/hls/region/4_signature.inc"
  }
};

template <class Config>
struct SignatureFrontEnd<Config, 4, false> {
  static void run(SAILMAP_SIGNATURE_PORTS(uint32_t)) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/1_to_base_4.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_once.inc"
#include "sailmap/hls/region/4_signature.inc"
  }
};

template <class Config>
struct SignatureFrontEnd<Config, 4, true> {
  static void run(SAILMAP_SIGNATURE_PORTS(uint32_t)) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/1_to_base_4.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_twice.inc"
#include "sailmap/hls/region/4_signature.inc"
  }
};

template <class Config>
struct SignatureFrontEnd<Config, 8, false> {
  static void run(SAILMAP_SIGNATURE_PORTS(uint64_t)) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/1_to_base_8.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_once.inc"
#include "sailmap/hls/region/4_signature.inc"
  }
};

template <class Config>
struct SignatureFrontEnd<Config, 8, true> {
  static void run(SAILMAP_SIGNATURE_PORTS(uint64_t)) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/1_to_base_8.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_twice.inc"
#include "sailmap/hls/region/4_signature.inc"
  }
};

}  // namespace hls
}  // namespace sailmap
