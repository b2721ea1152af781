#include "sailmap/hls/reduce_pixels.hpp"

#include "kernels.hpp"

void sailmap_reduce_pixels(sailmap::hls::stream<uint16_t>& intensity, sailmap::hls::stream<uint64_t>& colours,
                           sailmap::hls::stream<uint16_t>& intensity_out,
                           sailmap::hls::stream<uint64_t>& colours_out, uint16_t width, uint16_t height) {
#pragma HLS interface mode = axis port = intensity
#pragma HLS interface mode = axis port = colours
#pragma HLS interface mode = axis port = intensity_out
#pragma HLS interface mode = axis port = colours_out
  sailmap::hls::reduce_pixels<sailmap::top::Config, 2>(intensity, colours, intensity_out, colours_out, width,
                                                       height);
}
