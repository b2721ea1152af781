#include "sailmap/hls/normalise.hpp"

#include "kernels.hpp"

void sailmap_normalise(sailmap::hls::stream<uint32_t>& gains, sailmap::hls::stream<uint64_t>& maps,
                       sailmap::hls::stream<uint32_t>& sum_out, uint16_t width, uint16_t height) {
#pragma HLS interface mode = axis port = gains
#pragma HLS interface mode = axis port = maps
#pragma HLS interface mode = axis port = sum_out
  sailmap::hls::normalise<sailmap::top::Config, 4, sailmap::hls::colour_kind>(gains, maps, sum_out, width,
                                                                              height);
}
