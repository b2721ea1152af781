#include "sailmap/hls/delay_line.hpp"

#include "kernels.hpp"

void sailmap_delay_line(sailmap::hls::stream<uint64_t>& in, sailmap::hls::stream<uint64_t>& out,
                        uint16_t width, uint16_t height) {
#pragma HLS interface mode = axis port = in
#pragma HLS interface mode = axis port = out
  sailmap::hls::delay_line<sailmap::top::Config, 2, sailmap::hls::BranchDelay<2>, uint64_t>(in, out, width,
                                                                                            height);
}
