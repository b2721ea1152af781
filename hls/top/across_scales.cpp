#include "sailmap/hls/across_scales.hpp"

#include "kernels.hpp"

void sailmap_across_scales(sailmap::hls::stream<uint64_t>& coarse, sailmap::hls::stream<uint64_t>& fine,
                           sailmap::hls::stream<uint64_t>& out, uint16_t width, uint16_t height) {
#pragma HLS interface mode = axis port = coarse
#pragma HLS interface mode = axis port = fine
#pragma HLS interface mode = axis port = out
  sailmap::hls::across_scales<sailmap::top::Config, 2, sailmap::hls::green_blue_pair>(coarse, fine, out,
                                                                                      width, height);
}
