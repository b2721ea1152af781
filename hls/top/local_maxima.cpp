#include "sailmap/hls/local_maxima.hpp"

#include "kernels.hpp"

void sailmap_local_maxima(sailmap::hls::stream<uint64_t>& in, sailmap::hls::stream<uint32_t>& out,
                          sailmap::hls::stream<uint8_t>& flags, uint16_t width, uint16_t height) {
#pragma HLS interface mode = axis port = in
#pragma HLS interface mode = axis port = out
#pragma HLS interface mode = axis port = flags
  sailmap::hls::local_maxima<sailmap::top::Config, sailmap::hls::green_blue_pair>(in, out, flags, width,
                                                                                  height);
}
