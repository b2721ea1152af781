// Top for devices that Vitis links, and for bare metal: pixels in memory to a signature in memory,
// sailmap/hls/signature_memory.hpp.
#pragma once

#include <cstdint>

#include "memory_pixels.hpp"
#include "sailmap/hls/memory_registers.h"

extern "C" {
void sailmap_signature_memory(const sailmap_memory_beat pixels[sailmap::top::frame_beats],
                              uint32_t record[SAILMAP_RECORD_WORDS], uint32_t report[SAILMAP_REPORT_WORDS],
                              uint32_t width, uint32_t height, uint32_t frame, uint32_t max_regions,
                              uint32_t stop_ratio, uint32_t box_side);
}
