#include "sailmap/hls/centre_surround.hpp"

#include "kernels.hpp"

void sailmap_centre_surround(sailmap::hls::stream<uint16_t>& intensity,
                             sailmap::hls::stream<uint64_t>& colours, sailmap::hls::stream<uint64_t>& on_off,
                             sailmap::hls::stream<uint64_t>& green_blue,
                             sailmap::hls::stream<uint64_t>& red_yellow, uint16_t width, uint16_t height) {
#pragma HLS interface mode = axis port = intensity
#pragma HLS interface mode = axis port = colours
#pragma HLS interface mode = axis port = on_off
#pragma HLS interface mode = axis port = green_blue
#pragma HLS interface mode = axis port = red_yellow
  sailmap::hls::centre_surround<sailmap::top::Config, 2>(intensity, colours, on_off, green_blue, red_yellow,
                                                         width, height);
}
