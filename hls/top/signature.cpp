#include "sailmap/hls/signature.hpp"

#include "kernels.hpp"

void sailmap_signature(sailmap::hls::stream<uint32_t>& intensity_maps,
                       sailmap::hls::stream<uint64_t>& colour_maps,
                       sailmap::hls::stream<uint64_t>& orientation_maps,
                       sailmap::hls::stream<uint64_t>& conspicuity_maps,
                       sailmap::hls::stream<uint16_t>& saliency, sailmap::hls::stream<uint32_t>& statistics,
                       sailmap::hls::stream<uint32_t>& record, uint16_t width, uint16_t height,
                       uint16_t max_regions, uint32_t stop_ratio, uint16_t box_side) {
#pragma HLS interface mode = axis port = intensity_maps
#pragma HLS interface mode = axis port = colour_maps
#pragma HLS interface mode = axis port = orientation_maps
#pragma HLS interface mode = axis port = conspicuity_maps
#pragma HLS interface mode = axis port = saliency
#pragma HLS interface mode = axis port = statistics
#pragma HLS interface mode = axis port = record
  sailmap::hls::signature<sailmap::top::Config>(intensity_maps, colour_maps, orientation_maps,
                                                conspicuity_maps, saliency, statistics, record, width, height,
                                                max_regions, stop_ratio, box_side);
}
