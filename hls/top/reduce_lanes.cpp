#include "sailmap/hls/reduce_lanes.hpp"

#include "kernels.hpp"

namespace {
// Four pixels a beat, whatever the front end's beat: the words that all wide beats are made of.
using Config4 = sailmap::hls::Config<SAILMAP_MAX_WIDTH, SAILMAP_MAX_HEIGHT, 4>;
}  // namespace

void sailmap_reduce_lanes(sailmap::hls::stream<uint64_t>& in, sailmap::hls::stream<uint32_t>& out,
                          uint16_t width, uint16_t height) {
#pragma HLS interface mode = axis port = in
#pragma HLS interface mode = axis port = out
  sailmap::hls::reduce_lanes<Config4, 0, 4, 1>(in, out, width, height);
}
