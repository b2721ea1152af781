// Top: the whole front end and the signature, sailmap/hls/signature_front_end.hpp.
#pragma once

#include <cstdint>

#include "configuration.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/stream.hpp"

using sailmap_pixels = sailmap::hls::bytes_t<sailmap::top::Config::beat>;

void sailmap_signature_front_end(sailmap::hls::stream<sailmap_pixels>& red,
                                 sailmap::hls::stream<sailmap_pixels>& green,
                                 sailmap::hls::stream<sailmap_pixels>& blue,
                                 sailmap::hls::stream<uint32_t>& record, uint16_t width, uint16_t height,
                                 uint16_t max_regions, uint32_t stop_ratio, uint16_t box_side);
