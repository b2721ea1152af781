// The frame of the tops between memory and memory.
#pragma once

#include "configuration.hpp"
#include "sailmap/hls/memory_kernel.hpp"

using sailmap_memory_beat = sailmap::hls::memory_beat<sailmap::top::Config::beat>;

namespace sailmap {
namespace top {

// Words of the largest frame: what co-simulation gives the port.
constexpr int frame_beats = Config::max_width / Config::beat * Config::max_height;

}  // namespace top
}  // namespace sailmap
