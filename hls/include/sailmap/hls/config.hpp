// Configuration of a front end: the largest frame it takes, its beat, its buffering. Wrong ones stop the
// compiler.
#pragma once

#include "sailmap/hls/geometry.hpp"

namespace sailmap {
namespace hls {

// MaxWidth x MaxHeight: the largest frame; run-time sizes may be anything from 64 x 64 up to it, the width a
// multiple of Beat. Beat: pixels a beat at the input, 1, 2, 4 or 8. DoubleBuffer: the next frame is stored
// while the last one is replayed, for twice the map memory.
template <int MaxWidth, int MaxHeight, int Beat, bool DoubleBuffer = false>
struct Config {
  static_assert(geometry::valid_side(MaxWidth) && geometry::valid_side(MaxHeight),
                "frame sides are 64 to 4096 pixels");
  static_assert(Beat == 1 || Beat == 2 || Beat == 4 || Beat == 8, "1, 2, 4 or 8 pixels a beat");
  static_assert(MaxWidth % Beat == 0, "the width must be a multiple of the beat");

  static constexpr int max_width = MaxWidth;
  static constexpr int max_height = MaxHeight;
  static constexpr int beat = Beat;
  static constexpr bool double_buffer = DoubleBuffer;

  // The longest row and the most pixels of pyramid level `level`.
  static constexpr int level_width(int level) { return geometry::level_side(MaxWidth, level); }
  static constexpr int level_height(int level) { return geometry::level_side(MaxHeight, level); }
  static constexpr int level_pixels(int level) { return level_width(level) * level_height(level); }

  // Columns and rows of level `level` of a frame of this width or height. Of a frame that it takes they lose
  // nothing by the mask, which tells a tool how few bits its counters need.
  static constexpr int columns(int width, int level) {
    return geometry::level_side(width, level) & geometry::ones(level_width(level));
  }
  static constexpr int rows(int height, int level) {
    return geometry::level_side(height, level) & geometry::ones(level_height(level));
  }

  // Whether the front end takes a frame of this size.
  static constexpr bool takes(int width, int height) {
    return geometry::valid_side(width) && geometry::valid_side(height) && width <= MaxWidth &&
           height <= MaxHeight && width % Beat == 0;
  }
};

template <int Beat, bool DoubleBuffer = false>
using Qvga = Config<320, 240, Beat, DoubleBuffer>;
template <int Beat, bool DoubleBuffer = false>
using Vga = Config<640, 480, Beat, DoubleBuffer>;
template <int Beat, bool DoubleBuffer = false>
using Hd720 = Config<1280, 720, Beat, DoubleBuffer>;
template <int Beat, bool DoubleBuffer = false>
using Hd1080 = Config<1920, 1080, Beat, DoubleBuffer>;

}  // namespace hls
}  // namespace sailmap
