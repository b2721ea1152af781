#include "sailmap/hls/join_pairs.hpp"

#include "kernels.hpp"

void sailmap_join_pairs(sailmap::hls::stream<uint32_t>& low, sailmap::hls::stream<uint8_t>& low_flags,
                        sailmap::hls::stream<uint32_t>& high, sailmap::hls::stream<uint8_t>& high_flags,
                        sailmap::hls::stream<uint64_t>& out, sailmap::hls::stream<uint8_t>& flags,
                        uint16_t width, uint16_t height) {
#pragma HLS interface mode = axis port = low
#pragma HLS interface mode = axis port = low_flags
#pragma HLS interface mode = axis port = high
#pragma HLS interface mode = axis port = high_flags
#pragma HLS interface mode = axis port = out
#pragma HLS interface mode = axis port = flags
  sailmap::hls::join_pairs<sailmap::top::Config, sailmap::hls::colour_kind>(low, low_flags, high, high_flags,
                                                                            out, flags, width, height);
}
