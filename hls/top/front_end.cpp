#include "front_end.hpp"

#include "sailmap/hls/front_end.hpp"

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
  sailmap::hls::FrontEnd<sailmap::top::Config>::run(red, green, blue, intensity_maps, colour_maps,
                                                    orientation_maps, conspicuity_maps, saliency, statistics,
                                                    width, height);
}
