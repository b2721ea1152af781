#include "front_end.hpp"

#include "sailmap/hls/front_end.hpp"

// The region stands in the top itself and its streams stand outside, rather than all of it in
// FrontEnd::run(): Bambu finds a dataflow region in the top alone, and streams best at file scope.
using namespace sailmap::hls;

#include "front_end_region.inc"  // its streams

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
#include "front_end_region.inc"  // its stages
}
