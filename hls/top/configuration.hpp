// Which front end the tops in this folder are: set by the tool's -D options, VGA with 4 pixels a beat
// without.
#pragma once

#include "sailmap/hls/config.hpp"

#ifndef SAILMAP_MAX_WIDTH
#define SAILMAP_MAX_WIDTH 640
#endif
#ifndef SAILMAP_MAX_HEIGHT
#define SAILMAP_MAX_HEIGHT 480
#endif
#ifndef SAILMAP_BEAT
#define SAILMAP_BEAT 4
#endif
#ifndef SAILMAP_DOUBLE_BUFFER
#define SAILMAP_DOUBLE_BUFFER false
#endif

namespace sailmap {
namespace top {

using Config = hls::Config<SAILMAP_MAX_WIDTH, SAILMAP_MAX_HEIGHT, SAILMAP_BEAT, SAILMAP_DOUBLE_BUFFER>;

}  // namespace top
}  // namespace sailmap
