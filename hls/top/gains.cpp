#include "kernels.hpp"
#include "sailmap/hls/normalise.hpp"

void sailmap_gains(sailmap::hls::stream<uint32_t>& statistics, sailmap::hls::stream<uint32_t>& statistics_out,
                   sailmap::hls::stream<uint32_t>& gains_out) {
#pragma HLS interface mode = axis port = statistics
#pragma HLS interface mode = axis port = statistics_out
#pragma HLS interface mode = axis port = gains_out
  sailmap::hls::gains<sailmap::top::Config, 4, sailmap::hls::colour_kind>(statistics, statistics_out,
                                                                          gains_out);
}
