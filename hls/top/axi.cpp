#include "axi.hpp"

#include "sailmap/hls/axi_front_end.hpp"

void sailmap_axi(sailmap::hls::stream<sailmap::hls::video_beat<sailmap::top::Config::beat> >& video,
                 sailmap::hls::stream<sailmap::hls::map_beat<32> >& intensity_maps,
                 sailmap::hls::stream<sailmap::hls::map_beat<64> >& colour_maps,
                 sailmap::hls::stream<sailmap::hls::map_beat<64> >& orientation_maps,
                 sailmap::hls::stream<sailmap::hls::map_beat<64> >& conspicuity_maps,
                 sailmap::hls::stream<sailmap::hls::map_beat<16> >& saliency,
                 sailmap::hls::stream<sailmap::hls::map_beat<32> >& statistics,
                 uint32_t status[sailmap::hls::status::words], uint16_t width, uint16_t height) {
#pragma HLS interface mode = axis port = video
#pragma HLS interface mode = axis port = intensity_maps
#pragma HLS interface mode = axis port = colour_maps
#pragma HLS interface mode = axis port = orientation_maps
#pragma HLS interface mode = axis port = conspicuity_maps
#pragma HLS interface mode = axis port = saliency
#pragma HLS interface mode = axis port = statistics
#pragma HLS interface mode = s_axilite port = status
#pragma HLS interface mode = s_axilite port = width
#pragma HLS interface mode = s_axilite port = height
#pragma HLS interface mode = s_axilite port = return
  sailmap::hls::axi_front_end<sailmap::top::Config>(video, intensity_maps, colour_maps, orientation_maps,
                                                    conspicuity_maps, saliency, statistics, status, width,
                                                    height);
}
