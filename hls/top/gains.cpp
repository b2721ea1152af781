#include "kernels.hpp"
#include "sailmap/hls/normalise.hpp"

void sailmap_gains(sailmap::hls::stream<uint32_t>& intensity, sailmap::hls::stream<uint32_t>& colour,
                   sailmap::hls::stream<uint32_t>& orientation,
                   sailmap::hls::stream<uint32_t>& statistics_out,
                   sailmap::hls::stream<uint32_t>& intensity_gains,
                   sailmap::hls::stream<uint32_t>& colour_gains,
                   sailmap::hls::stream<uint32_t>& orientation_gains) {
#pragma HLS interface mode = axis port = intensity
#pragma HLS interface mode = axis port = colour
#pragma HLS interface mode = axis port = orientation
#pragma HLS interface mode = axis port = statistics_out
#pragma HLS interface mode = axis port = intensity_gains
#pragma HLS interface mode = axis port = colour_gains
#pragma HLS interface mode = axis port = orientation_gains
  sailmap::hls::gains_of_features<sailmap::top::Config>(intensity, colour, orientation, statistics_out,
                                                        intensity_gains, colour_gains, orientation_gains);
}
