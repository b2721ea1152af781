// One level of the pyramid (spec 3), one pixel a word, any size.
//
// Streams in and out: intensity, and green, blue, red, yellow as lanes; in raster order, level `Fine` in,
// Fine + 1 out. Formats: grey_sum (level 0) or intensity, colour. Latency: 2 rows and 2 columns of level
// Fine. II: 2 cycles an output column, that is one input pixel a cycle. Error: see pyramid.hpp.
#pragma once

#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/pyramid.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

template <class Config, int Fine>
struct ReducePixels {
  static constexpr int fine = Fine;
  static constexpr int columns = Config::level_width(Fine + 1);
};

// All five channels of a pixel.
struct PyramidPixel {
  uint16_t intensity;
  uint64_t colours;
};

// Five neighbours in a row.
struct PixelWindow {
  PyramidPixel a, b, c, d, e;
};

template <int Index>
inline FiveTaps colour_taps(const PixelWindow& p) {
  const FiveTaps taps = {lane<Index>(p.a.colours), lane<Index>(p.b.colours), lane<Index>(p.c.colours),
                         lane<Index>(p.d.colours), lane<Index>(p.e.colours)};
  return taps;
}

// Adds a row's five pixels around column x to one channel, in turn (SAILMAP_SHARED); returns the sample that
// they complete. One function for all channels, but that level 0 rounds intensity another way.
template <class Stage, int Channel>
inline uint16_t add_in_turn(int x, const FiveTaps& p, uint32_t kind) {
  constexpr int fine = Stage::fine;
  constexpr int function = fine == 0 && Channel == 0 ? 0 : 1;
  uint64_t* const sums = ColumnSums<Stage, Channel, 0>::sums;
  const uint64_t after =
      shared_column<fine, function>(sums[x], p.a, p.b, p.c, p.d, p.e, tagged<2 * fine + function>(kind));
  sums[x] = sums_of(after);
  return sample_of(after);
}

template <class Stage>
inline PyramidPixel add_window(int x, const PixelWindow& p, uint32_t kind) {
  const FiveTaps taps = {p.a.intensity, p.b.intensity, p.c.intensity, p.d.intensity, p.e.intensity};
  PyramidPixel out = {0, 0};
  out.intensity = add_in_turn<Stage, 0>(x, taps, kind);
  out.colours = pack(
      add_in_turn<Stage, 1>(x, colour_taps<0>(p), kind), add_in_turn<Stage, 2>(x, colour_taps<1>(p), kind),
      add_in_turn<Stage, 3>(x, colour_taps<2>(p), kind), add_in_turn<Stage, 4>(x, colour_taps<3>(p), kind));
  return out;
}

template <class Stage>
inline PyramidPixel last_of_columns(int x) {
  PyramidPixel out = {0, 0};
  out.intensity = last_of_column<Stage, 0, 0>(x);
  out.colours = pack(last_of_column<Stage, 1, 0>(x), last_of_column<Stage, 2, 0>(x),
                     last_of_column<Stage, 3, 0>(x), last_of_column<Stage, 4, 0>(x));
  return out;
}

template <class Config, int Fine>
void reduce_pixels(stream<uint16_t>& intensity, stream<uint64_t>& colours, stream<uint16_t>& intensity_out,
                   stream<uint64_t>& colours_out, uint16_t width, uint16_t height) {
  using Stage = ReducePixels<Config, Fine>;
  const int w = Config::columns(width, Fine);
  const int h = Config::rows(height, Fine);
  const int columns = geometry::half(w);
#pragma nounroll
  for (int y = 0; y < h; ++y) {
    const uint32_t kind = row_kind::of(y, h);
    PixelWindow p = PixelWindow();
    p.c.intensity = intensity.read();
    p.c.colours = colours.read();
    p.a = p.c;
    p.b = p.c;
#pragma nounroll
    for (int x = 0; x < columns; ++x) {
      SAILMAP_PIPELINE_II(2)
      p.d = p.c;
      if (2 * x + 1 < w) {
        p.d.intensity = intensity.read();
        p.d.colours = colours.read();
      }
      p.e = p.d;
      if (2 * x + 2 < w) {
        p.e.intensity = intensity.read();
        p.e.colours = colours.read();
      }
      const PyramidPixel out = add_window<Stage>(x, p, kind);
      if (row_kind::emits(kind)) {
        intensity_out.write(out.intensity);
        colours_out.write(out.colours);
      }
      p.a = p.c;
      p.b = p.d;
      p.c = p.e;
    }
  }
#pragma nounroll
  for (int x = 0; x < columns; ++x) {
    SAILMAP_PIPELINE
    const PyramidPixel out = last_of_columns<Stage>(x);
    intensity_out.write(out.intensity);
    colours_out.write(out.colours);
  }
}

}  // namespace hls
}  // namespace sailmap
