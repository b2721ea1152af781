#include "kernels.hpp"
#include "sailmap/hls/gabor.hpp"

void sailmap_orientation(sailmap::hls::stream<uint16_t>& intensity, sailmap::hls::stream<uint64_t>& ori_0_45,
                         sailmap::hls::stream<uint64_t>& ori_90_135, uint16_t width, uint16_t height) {
#pragma HLS interface mode = axis port = intensity
#pragma HLS interface mode = axis port = ori_0_45
#pragma HLS interface mode = axis port = ori_90_135
  sailmap::hls::orientation_energy<sailmap::top::Config, 2>(intensity, ori_0_45, ori_90_135, width, height);
}
