#include "sailmap/hls/centre_surround.hpp"

#include "kernels.hpp"

void sailmap_centre_surround(sailmap::hls::stream<uint16_t>& intensity,
                             sailmap::hls::stream<uint64_t>& colours,
                             sailmap::hls::stream<uint32_t>& intensity_out,
                             sailmap::hls::stream<uint64_t>& colours_out, uint16_t width, uint16_t height) {
#pragma HLS interface mode = axis port = intensity
#pragma HLS interface mode = axis port = colours
#pragma HLS interface mode = axis port = intensity_out
#pragma HLS interface mode = axis port = colours_out
  sailmap::hls::centre_surround<sailmap::top::Config, 2>(intensity, colours, intensity_out, colours_out,
                                                         width, height);
}
