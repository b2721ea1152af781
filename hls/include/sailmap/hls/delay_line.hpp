// Delay lines and forks: what keeps branches of the dataflow in step without deep FIFOs.
//
// Source: none, plumbing. Streams: native words, one a pixel of level `Level`, one frame a call in raster
// order. Latency of a delay line: `rows` rows and `columns` columns; of a fork: 0. II 1. Exact, no
// arithmetic. Rows stand alone: the last `columns` pixels of a row do not wait for the next row, in which,
// after a decimation, there may be nothing.
// How long they are:
// delays.hpp.
#pragma once

#include "sailmap/hls/delays.hpp"
#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

// The memory of a delay line; one per level, kind of delay and word.
template <int Level, class Delay, class Word, int Capacity>
struct DelayMemory {
  static Word words[Capacity];
};
template <int Level, class Delay, class Word, int Capacity>
SAILMAP_MEMORY Word DelayMemory<Level, Delay, Word, Capacity>::words[Capacity];

// `width` and `height` are of level 0, as everywhere.
template <class Config, int Level, class Delay, class Word>
void delay_line(stream<Word>& in, stream<Word>& out, uint16_t width, uint16_t height) {
  // One row more than are delayed: the oldest is still being written out while the newest comes in.
  using Memory = DelayMemory<Level, Delay, Word, (Delay::rows + 1) * Config::level_width(Level)>;
  const int w = Config::columns(width, Level);
  const int h = Config::rows(height, Level);
  int newest = 0;
#pragma nounroll
  for (int y = 0; y < h + Delay::rows; ++y) {
    const int oldest = newest == Delay::rows * w ? 0 : newest + w;
#pragma nounroll
    for (int x = 0; x < w + Delay::columns; ++x) {
      SAILMAP_PIPELINE
      if (y < h && x < w) Memory::words[newest + x] = in.read();
      if (y >= Delay::rows && x >= Delay::columns) out.write(Memory::words[oldest + x - Delay::columns]);
    }
    newest = oldest;
  }
}

// One pyramid level, intensity and colours, to two branches.
template <class Config, int Level>
void fork_level(stream<uint16_t>& intensity, stream<uint64_t>& colours, stream<uint16_t>& intensity_a,
                stream<uint64_t>& colours_a, stream<uint16_t>& intensity_b, stream<uint64_t>& colours_b,
                uint16_t width, uint16_t height) {
  const int pixels = Config::columns(width, Level) * Config::rows(height, Level);
#pragma nounroll
  for (int i = 0; i < pixels; ++i) {
    SAILMAP_PIPELINE
    const uint16_t grey = intensity.read();
    const uint64_t colour = colours.read();
    intensity_a.write(grey);
    colours_a.write(colour);
    intensity_b.write(grey);
    colours_b.write(colour);
  }
}

// The intensity of one level to its centre-surround and its Gabor stage.
template <class Config, int Level>
void fork_intensity(stream<uint16_t>& in, stream<uint16_t>& a, stream<uint16_t>& b, uint16_t width,
                    uint16_t height) {
  const int pixels = Config::columns(width, Level) * Config::rows(height, Level);
#pragma nounroll
  for (int i = 0; i < pixels; ++i) {
    SAILMAP_PIPELINE
    const uint16_t grey = in.read();
    a.write(grey);
    b.write(grey);
  }
}

}  // namespace hls
}  // namespace sailmap
