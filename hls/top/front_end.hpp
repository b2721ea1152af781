// Top: the whole front end, sailmap/hls/front_end.hpp.
#pragma once

#include <cstdint>

#include "configuration.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/stream.hpp"

using sailmap_pixels = sailmap::hls::bytes_t<sailmap::top::Config::beat>;

void sailmap_front_end(sailmap::hls::stream<sailmap_pixels>& red, sailmap::hls::stream<sailmap_pixels>& green,
                       sailmap::hls::stream<sailmap_pixels>& blue,
                       sailmap::hls::stream<uint32_t>& intensity_maps,
                       sailmap::hls::stream<uint64_t>& colour_maps,
                       sailmap::hls::stream<uint64_t>& orientation_maps,
                       sailmap::hls::stream<uint64_t>& conspicuity_maps,
                       sailmap::hls::stream<uint16_t>& saliency, sailmap::hls::stream<uint32_t>& statistics,
                       uint16_t width, uint16_t height);
