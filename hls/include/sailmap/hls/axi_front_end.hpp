// The front end between AXI4-Stream video and AXI4-Stream maps, as one dataflow region and the check before
// it.
//
// Ports: axi_video.hpp says what the streams carry. width and height come, and status goes, over AXI4-Lite. A
// size that Config does not take is refused: nothing is read and nothing written but status[refused].
#pragma once

#include "sailmap/hls/axi_video.hpp"
#include "sailmap/hls/front_end.hpp"

namespace sailmap {
namespace hls {

#define SAILMAP_AXI_PORTS                                                                  \
  stream<video_beat<Config::beat> >&video, stream<map_beat<32> >&intensity_maps_axis,      \
      stream<map_beat<64> >&colour_maps_axis, stream<map_beat<64> >&orientation_maps_axis, \
      stream<map_beat<64> >&conspicuity_maps_axis, stream<map_beat<16> >&saliency_axis,    \
      stream<map_beat<32> >&statistics_axis, uint32_t *status_out, uint16_t width, uint16_t height

template <class Config, int Beat = Config::beat, bool DoubleBuffer = Config::double_buffer>
struct AxiRegion;

template <class Config>
struct AxiRegion<Config, 1, false> {
  static void run(SAILMAP_AXI_PORTS) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/0_video_in.inc"
#include "sailmap/hls/region/1_to_base_1.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_once.inc"
#include "sailmap/hls/region/4_maps_out.inc"
  }
};

template <class Config>
struct AxiRegion<Config, 1, true> {
  static void run(SAILMAP_AXI_PORTS) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/0_video_in.inc"
#include "sailmap/hls/region/1_to_base_1.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_twice.inc"
#include "sailmap/hls/region/4_maps_out.inc"
  }
};

template <class Config>
struct AxiRegion<Config, 2, false> {
  static void run(SAILMAP_AXI_PORTS) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/0_video_in.inc"
#include "sailmap/hls/region/1_to_base_2.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_once.inc"
#include "sailmap/hls/region/4_maps_out.inc"
  }
};

template <class Config>
struct AxiRegion<Config, 2, true> {
  static void run(SAILMAP_AXI_PORTS) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/0_video_in.inc"
#include "sailmap/hls/region/1_to_base_2.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_twice.inc"
#include "sailmap/hls/region/4_maps_out.inc"
  }
};

template <class Config>
struct AxiRegion<Config, 4, false> {
  static void run(SAILMAP_AXI_PORTS) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/0_video_in.inc"
#include "sailmap/hls/region/1_to_base_4.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_once.inc"
#include "sailmap/hls/region/4_maps_out.inc"
  }
};

template <class Config>
struct AxiRegion<Config, 4, true> {
  static void run(SAILMAP_AXI_PORTS) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/0_video_in.inc"
#include "sailmap/hls/region/1_to_base_4.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_twice.inc"
#include "sailmap/hls/region/4_maps_out.inc"
  }
};

template <class Config>
struct AxiRegion<Config, 8, false> {
  static void run(SAILMAP_AXI_PORTS) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/0_video_in.inc"
#include "sailmap/hls/region/1_to_base_8.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_once.inc"
#include "sailmap/hls/region/4_maps_out.inc"
  }
};

template <class Config>
struct AxiRegion<Config, 8, true> {
  static void run(SAILMAP_AXI_PORTS) {
#pragma HLS dataflow
#include "sailmap/hls/region/0_map_streams.inc"
#include "sailmap/hls/region/0_video_in.inc"
#include "sailmap/hls/region/1_to_base_8.inc"
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_twice.inc"
#include "sailmap/hls/region/4_maps_out.inc"
  }
};

template <class Config>
inline void axi_front_end(SAILMAP_AXI_PORTS) {
  if (!Config::takes(width, height)) {
    status_out[status::refused] = ++VideoState<Config>::counts[status::refused];
    return;
  }
  AxiRegion<Config>::run(video, intensity_maps_axis, colour_maps_axis, orientation_maps_axis,
                         conspicuity_maps_axis, saliency_axis, statistics_axis, status_out, width, height);
}

}  // namespace hls
}  // namespace sailmap
