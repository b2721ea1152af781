// Top for devices that Vitis links, and for bare metal: the front end from memory to memory,
// sailmap/hls/memory_front_end.hpp.
#pragma once

#include <cstdint>

#include "configuration.hpp"
#include "memory_pixels.hpp"
#include "sailmap/hls/memory_front_end.hpp"

namespace sailmap {
namespace top {

// Words of the largest frame: what co-simulation gives the ports.
constexpr int map_words =
    hls::geometry::base_side(Config::max_width) * hls::geometry::base_side(Config::max_height);

}  // namespace top
}  // namespace sailmap

extern "C" {
void sailmap_memory(const sailmap_memory_beat pixels[sailmap::top::frame_beats],
                    uint32_t intensity_maps[sailmap::top::map_words],
                    uint64_t colour_maps[sailmap::top::map_words],
                    uint64_t orientation_maps[sailmap::top::map_words],
                    uint64_t conspicuity_maps[sailmap::top::map_words],
                    uint16_t saliency[sailmap::top::map_words], uint32_t statistics[SAILMAP_STATISTICS_WORDS],
                    uint32_t report[SAILMAP_REPORT_WORDS], uint32_t width, uint32_t height, uint32_t frame);
}
