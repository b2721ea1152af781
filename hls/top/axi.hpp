// Top for AMD devices: the front end between AXI4-Stream video and maps, sailmap/hls/axi_front_end.hpp.
#pragma once

#include <cstdint>

#include "configuration.hpp"
#include "sailmap/hls/axi_video.hpp"
#include "sailmap/hls/stream.hpp"

void sailmap_axi(sailmap::hls::stream<sailmap::hls::video_beat<sailmap::top::Config::beat> >& video,
                 sailmap::hls::stream<sailmap::hls::map_beat<32> >& intensity_maps,
                 sailmap::hls::stream<sailmap::hls::map_beat<64> >& colour_maps,
                 sailmap::hls::stream<sailmap::hls::map_beat<64> >& orientation_maps,
                 sailmap::hls::stream<sailmap::hls::map_beat<64> >& conspicuity_maps,
                 sailmap::hls::stream<sailmap::hls::map_beat<16> >& saliency,
                 sailmap::hls::stream<sailmap::hls::map_beat<32> >& statistics,
                 uint32_t status[sailmap::hls::status::words], uint16_t width, uint16_t height);
