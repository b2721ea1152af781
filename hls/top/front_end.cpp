#include "front_end.hpp"

#include "sailmap/hls/front_end.hpp"

using namespace sailmap::hls;

void sailmap_front_end(sailmap::hls::stream<sailmap_pixels>& red, sailmap::hls::stream<sailmap_pixels>& green,
                       sailmap::hls::stream<sailmap_pixels>& blue,
                       sailmap::hls::stream<uint32_t>& intensity_maps,
                       sailmap::hls::stream<uint64_t>& colour_maps,
                       sailmap::hls::stream<uint64_t>& orientation_maps,
                       sailmap::hls::stream<uint64_t>& conspicuity_maps,
                       sailmap::hls::stream<uint16_t>& saliency, sailmap::hls::stream<uint32_t>& statistics,
                       uint16_t width, uint16_t height) {
#pragma HLS interface mode = axis port = red
#pragma HLS interface mode = axis port = green
#pragma HLS interface mode = axis port = blue
#pragma HLS interface mode = axis port = intensity_maps
#pragma HLS interface mode = axis port = colour_maps
#pragma HLS interface mode = axis port = orientation_maps
#pragma HLS interface mode = axis port = conspicuity_maps
#pragma HLS interface mode = axis port = saliency
#pragma HLS interface mode = axis port = statistics
#pragma HLS dataflow
  using Config = sailmap::top::Config;
#if SAILMAP_BEAT == 1
#include "sailmap/hls/region/1_to_base_1.inc"
#elif SAILMAP_BEAT == 2
#include "sailmap/hls/region/1_to_base_2.inc"
#elif SAILMAP_BEAT == 4
#include "sailmap/hls/region/1_to_base_4.inc"
#else
#include "sailmap/hls/region/1_to_base_8.inc"
#endif
#include "sailmap/hls/region/2_levels.inc"
#include "sailmap/hls/region/3_store_once.inc"
}
