#include "sailmap/hls/peaks.hpp"

#include "kernels.hpp"

void sailmap_peaks(sailmap::hls::stream<uint64_t>& in, sailmap::hls::stream<uint8_t>& in_flags,
                   sailmap::hls::stream<uint32_t>& statistics, sailmap::hls::stream<uint64_t>& maps_out,
                   sailmap::hls::stream<uint64_t>& out, uint16_t width, uint16_t height) {
#pragma HLS interface mode = axis port = in
#pragma HLS interface mode = axis port = in_flags
#pragma HLS interface mode = axis port = statistics
#pragma HLS interface mode = axis port = maps_out
#pragma HLS interface mode = axis port = out
  sailmap::hls::peaks<sailmap::top::Config>(in, in_flags, statistics, maps_out, out, width, height);
}
