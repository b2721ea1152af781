// Delay lines and forks: what keeps branches of the dataflow in step without deep FIFOs.
//
// Source: none, plumbing. Streams: native words, one a pixel of level `Level`, one frame a call in raster
// order. Latency of a delay line: `rows` rows and `columns` columns; of a fork: 0. II 1. Exact, no
// arithmetic. Rows stand alone: the last `columns` pixels of a row do not wait for the next row, in which,
// after a decimation, there may be nothing.
//
// Which delays are right, in pixels of a level l (lags count from the arrival of the pyramid pixel):
// - The Gabor stage is ready 4 rows and 4 columns after a pixel, the centre-surround stage 7 and 7. The
// intensity goes
//   into Gabor 3 rows and 3 columns late, so that all maps of a level come in step.
// - Row k of level l+1 exists when row 2k+2 of level l has been read, and its sum is ready
// `sum_lag_rows(l+1)` rows of
//   level l+1 later. The row y = 2k-1 of the interpolated sum needs row k. So the sum for row y is ready with
//   row 2(k + sum_lag_rows(l+1)) + 2 = y + 2 sum_lag_rows(l+1) + 3 of level l: the lag of level l. What the
//   level's own contrast stage lags by itself is taken off: the rest is the delay of its branch. With columns
//   it is the same, but that the interpolation waits for the second of its two coarse columns.
#pragma once

#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

// Rows of level `level` between a pyramid row and the across-scales sum of that row.
constexpr int sum_lag_rows(int level) {
  return level == geometry::top_level ? geometry::surround_radius_large : 2 * sum_lag_rows(level + 1) + 3;
}
// The same for columns within a row: a decimation waits for 2 columns, an interpolation for one coarse one.
constexpr int sum_lag_columns(int level) {
  return level == geometry::top_level ? geometry::surround_radius_large : 2 * sum_lag_columns(level + 1) + 4;
}

// The delay of the five pyramid channels of a level before its contrast stages.
template <int Level>
struct BranchDelay {
  static constexpr int rows = sum_lag_rows(Level) - geometry::surround_radius_large;
  static constexpr int columns = sum_lag_columns(Level) - geometry::surround_radius_large;
};

// The further delay of the intensity before the Gabor stage.
struct GaborDelay {
  static constexpr int rows = geometry::surround_radius_large - geometry::gabor_radius;
  static constexpr int columns = geometry::surround_radius_large - geometry::gabor_radius;
};

// The memory of a delay line; one per level, kind of delay and word.
template <int Level, class Delay, class Word, int Capacity>
struct DelayMemory {
  static Word words[Capacity];
};
template <int Level, class Delay, class Word, int Capacity>
Word DelayMemory<Level, Delay, Word, Capacity>::words[Capacity];

// `width` and `height` are of level 0, as everywhere.
template <class Config, int Level, class Delay, class Word>
void delay_line(stream<Word>& in, stream<Word>& out, uint16_t width, uint16_t height) {
  // One row more than are delayed: the oldest is still being written out while the newest comes in.
  typedef DelayMemory<Level, Delay, Word, (Delay::rows + 1) * Config::level_width(Level)> Memory;
  const int w = geometry::level_side(width, Level);
  const int h = geometry::level_side(height, Level);
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
  const int pixels = geometry::level_side(width, Level) * geometry::level_side(height, Level);
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
  const int pixels = geometry::level_side(width, Level) * geometry::level_side(height, Level);
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
