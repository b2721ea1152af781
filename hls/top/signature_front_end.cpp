#include "signature_front_end.hpp"

#include "sailmap/hls/signature_front_end.hpp"

// As in front_end.cpp: the region in the top itself, its streams at file scope.
using namespace sailmap::hls;

#include "front_end_region.inc"  // the front end's streams
#include "sailmap/hls/region/0_map_streams.inc"

void sailmap_signature_front_end(sailmap::hls::stream<sailmap_pixels>& red,
                                 sailmap::hls::stream<sailmap_pixels>& green,
                                 sailmap::hls::stream<sailmap_pixels>& blue,
                                 sailmap::hls::stream<uint32_t>& record, uint16_t width, uint16_t height,
                                 uint16_t max_regions, uint32_t stop_ratio, uint16_t box_side) {
#pragma HLS interface mode = axis port = red
#pragma HLS interface mode = axis port = green
#pragma HLS interface mode = axis port = blue
#pragma HLS interface mode = axis port = record
#pragma HLS dataflow
  using Config = sailmap::top::Config;
  using ::saliency;              // the stream, not the function of section 7
#include "front_end_region.inc"  // its stages
#include "sailmap/hls/region/4_signature.inc"
}
