#include "sailmap/hls/channels.hpp"

#include "kernels.hpp"

namespace {
// Four pixels a beat, whatever the front end's beat: the words that all wide beats are made of.
using Config4 = sailmap::hls::Config<SAILMAP_MAX_WIDTH, SAILMAP_MAX_HEIGHT, 4>;
}  // namespace

void sailmap_channels(sailmap::hls::stream<uint32_t>& red, sailmap::hls::stream<uint32_t>& green,
                      sailmap::hls::stream<uint32_t>& blue, sailmap::hls::stream<uint64_t>& intensity_out,
                      sailmap::hls::stream<uint64_t>& green_out, sailmap::hls::stream<uint64_t>& blue_out,
                      sailmap::hls::stream<uint64_t>& red_out, sailmap::hls::stream<uint64_t>& yellow_out,
                      uint16_t width, uint16_t height) {
#pragma HLS interface mode = axis port = red
#pragma HLS interface mode = axis port = green
#pragma HLS interface mode = axis port = blue
#pragma HLS interface mode = axis port = intensity_out
#pragma HLS interface mode = axis port = green_out
#pragma HLS interface mode = axis port = blue_out
#pragma HLS interface mode = axis port = red_out
#pragma HLS interface mode = axis port = yellow_out
  sailmap::hls::channels_4<Config4, 0>(red, green, blue, intensity_out, green_out, blue_out, red_out,
                                       yellow_out, width, height);
}
