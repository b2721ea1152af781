// Centre-surround contrast, spec section 4: centre against the means of the 7x7 and the 15x15 window.
//
// Streams, level `Level`, one pixel a word, raster order. In: intensity; green, blue, red, yellow as lanes.
// Out: intensity on and off as lanes; the four colours' on as lanes. Formats: intensity, colour in;
// intensity_contrast, colour_contrast out. Latency: 7 rows and 7 columns. II 1 on the base level, 4 and 16 on
// the coarser ones. Rows stand alone: a row takes 14 words of filling and 7 of flushing. Maximum error
// against the exact contrast of the exact level: accuracy::contrast_error; of the same samples: half a unit
// of the output.
//
// Box sums run: a column's sum takes in one pixel and lets one go a row, a window's sum one column sum a
// column. The pixels that enter and leave are those of the newest row and of 4, 7 (the centre), 11 and 15
// rows before it; one row memory after the other holds them, each with one load and one store a pixel.
#pragma once

#include "sailmap/hls/arithmetic.hpp"
#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

constexpr int small_side = 2 * geometry::surround_radius_small + 1;
constexpr int large_side = 2 * geometry::surround_radius_large + 1;
// From the newest row or column: to where the small window begins, to the centre, to behind the small and
// large window.
constexpr int to_small = geometry::surround_radius_large - geometry::surround_radius_small;
constexpr int to_centre = geometry::surround_radius_small;  // from where the small window begins
constexpr int to_end = geometry::surround_radius_small + 1;

template <class Config, int Level>
struct CentreSurround {
  static constexpr int columns = Config::level_width(Level);
};

// `Rows` rows of words; Segment tells the memories of a stage apart.
template <class Stage, int Segment, class Word, int Rows>
struct RowMemory {
  static Word words[Rows * Stage::columns];
};
template <class Stage, int Segment, class Word, int Rows>
SAILMAP_MEMORY Word RowMemory<Stage, Segment, Word, Rows>::words[Rows * Stage::columns];

// Sums of the columns of one channel: over 15 rows low, over 7 rows high.
template <class Stage, int Channel>
struct BoxColumns {
  static uint64_t sums[Stage::columns];
};
template <class Stage, int Channel>
SAILMAP_MEMORY uint64_t BoxColumns<Stage, Channel>::sums[Stage::columns];

// Where each row memory is; the offsets are those of a slot's first word.
struct RowSlots {
  int row;  // 0 is the first row of the frame, `height` and on are its last one again
  int width;
  int first;          // to_small rows
  int first_before;   // the slot of the row before
  int second;         // to_centre rows
  int third, fourth;  // to_end and to_small rows

  void start(int w) {
    row = 0;
    width = w;
    first = 0;
    first_before = 0;
    second = 0;
    third = 0;
    fourth = 0;
  }
  void advance() {
    ++row;
    first_before = first;
    first = first == (to_small - 1) * width ? 0 : first + width;
    second = second == (to_centre - 1) * width ? 0 : second + width;
    third = third == (to_end - 1) * width ? 0 : third + width;
    fourth = fourth == (to_small - 1) * width ? 0 : fourth + width;
  }
};

// The pixels of one column that matter to the sums.
template <class Word>
struct ColumnTaps {
  Word newest, small_in, centre, small_out, large_out;
};

// Before the frame stands its first row, over and over: the first memory still has it in slot 0 when it is
// needed, and what a later memory is given in its first rows is that row already.
template <class Stage, class Word>
inline ColumnTaps<Word> column_taps(Word read, bool beyond, int x, const RowSlots& slots) {
  Word* const first = RowMemory<Stage, 1, Word, to_small>::words;
  Word* const second = RowMemory<Stage, 2, Word, to_centre>::words;
  Word* const third = RowMemory<Stage, 3, Word, to_end>::words;
  Word* const fourth = RowMemory<Stage, 4, Word, to_small>::words;
  ColumnTaps<Word> taps = ColumnTaps<Word>();
  const Word again = first[slots.first_before + x];
  taps.newest = beyond ? again : read;
  const Word a = first[(slots.row < to_small ? 0 : slots.first) + x];
  taps.small_in = slots.row == 0 ? taps.newest : a;
  first[slots.first + x] = taps.newest;
  const Word b = second[slots.second + x];
  taps.centre = slots.row < to_centre ? taps.small_in : b;
  second[slots.second + x] = taps.small_in;
  const Word c = third[slots.third + x];
  taps.small_out = slots.row < to_end ? taps.centre : c;
  third[slots.third + x] = taps.centre;
  const Word d = fourth[slots.fourth + x];
  taps.large_out = slots.row < to_small ? taps.small_out : d;
  fourth[slots.fourth + x] = taps.small_out;
  return taps;
}

// Column sums over the large and the small window, and the centre pixel, of one channel.
struct BoxColumn {
  uint32_t large, small;
  uint16_t centre;
};

// The first row stands for all above it. Selections of values already there rather than cases, so that loads
// need not wait for them.
template <class Stage, int Channel>
inline BoxColumn box_column(int x, bool first_row, uint16_t newest, uint16_t small_in, uint16_t centre,
                            uint16_t small_out, uint16_t large_out) {
  uint64_t* const sums = BoxColumns<Stage, Channel>::sums;
  const uint64_t stored = sums[x];
  const uint64_t before = first_row ? 0 : stored;
  const uint32_t large_enters = first_row ? 16U * newest : newest + 0U;
  const uint32_t large_leaves = first_row ? newest : large_out;
  const uint32_t small_enters = first_row ? 8U * newest : small_in + 0U;
  const uint32_t small_leaves = first_row ? newest : small_out;
  static_assert(large_side == 15 && small_side == 7, "the first row weighs 16 - 1 and 8 - 1");
  BoxColumn out = {0, 0, centre};
  out.large = static_cast<uint32_t>(before) + large_enters - large_leaves;
  out.small = static_cast<uint32_t>(before >> 32) + small_enters - small_leaves;
  sums[x] = static_cast<uint64_t>(out.small) << 32 | out.large;
  return out;
}

template <class Stage, int Channel, int Index, class Word>
inline BoxColumn box_lane(int x, bool first_row, const ColumnTaps<Word>& taps) {
  return box_column<Stage, Channel>(x, first_row, lane<Index>(taps.newest), lane<Index>(taps.small_in),
                                    lane<Index>(taps.centre), lane<Index>(taps.small_out),
                                    lane<Index>(taps.large_out));
}

// The window sums of one channel as they run along a row. The newest column is 7 to the right of the centre.
// A sum is always that of the columns in its register, so nothing is set at the start of a row: the row's
// first column goes in until there is nothing else.
struct BoxWindow {
  uint32_t large, small;
  uint16_t centre;
  ShiftRegister<large_side, uint32_t> large_columns;
  ShiftRegister<to_small, uint32_t> until_small;
  ShiftRegister<small_side, uint32_t> small_columns;
  ShiftRegister<geometry::surround_radius_large, uint16_t> centres;

  void next(const BoxColumn& column) {
    large += column.large - large_columns.push(column.large);
    const uint32_t enters = until_small.push(column.small);
    small += enters - small_columns.push(enters);
    centre = centres.push(column.centre);
  }
};

// contrast() of the centre; the coarsest level has the time to take one channel after the other through it.
// Level 3 has less than its number of pixels says: its rows come in the time of one row of level 2.
template <int Level, bool IsFine = Level != geometry::top_level>
struct Contrasts {
  static uint32_t of(uint16_t centre, uint32_t small, uint32_t large, int sign) {
    return contrast(centre, static_cast<int32_t>(small), static_cast<int32_t>(large), sign);
  }
};
template <int Level>
SAILMAP_SHARED uint32_t shared_contrast(uint16_t centre, uint32_t small, uint32_t large, bool off) {
  const auto small_sum = static_cast<int32_t>(small & ((1U << formats::intensity_box_small::word) - 1));
  const auto large_sum = static_cast<int32_t>(large & ((1U << formats::intensity_box_large::word) - 1));
  return contrast(centre, small_sum, large_sum, off ? -1 : 1);
}
template <int Level>
struct Contrasts<Level, false> {
  static uint32_t of(uint16_t centre, uint32_t small, uint32_t large, int sign) {
    return shared_contrast<Level>(centre, small, large, sign < 0);
  }
};

template <int Level>
inline uint32_t on_contrast(const BoxWindow& w) {
  return Contrasts<Level>::of(w.centre, w.small, w.large, 1);
}
template <int Level>
inline uint32_t off_contrast(const BoxWindow& w) {
  return Contrasts<Level>::of(w.centre, w.small, w.large, -1);
}

template <class Config, int Level>
void centre_surround(stream<uint16_t>& intensity, stream<uint64_t>& colours, stream<uint64_t>& on_off,
                     stream<uint64_t>& green_blue, stream<uint64_t>& red_yellow, uint16_t width,
                     uint16_t height) {
  using Stage = CentreSurround<Config, Level>;
  constexpr int radius = geometry::surround_radius_large;
  constexpr int filling = large_side - 1;  // the first column once more, so often
  const int w = Config::columns(width, Level);
  const int h = Config::rows(height, Level);
  RowSlots slots = RowSlots();
  slots.start(w);
  BoxColumn c0 = {0, 0, 0};
  BoxColumn c1 = c0;
  BoxColumn c2 = c0;
  BoxColumn c3 = c0;
  BoxColumn c4 = c0;
  BoxWindow w0 = BoxWindow();
  BoxWindow w1 = w0;
  BoxWindow w2 = w0;
  BoxWindow w3 = w0;
  BoxWindow w4 = w0;
#pragma nounroll
  for (int y = 0; y < h + radius; ++y) {
    int x = 0;
#pragma nounroll
    for (int i = 0; i < filling + w + radius; ++i) {
      SAILMAP_PIPELINE_II(geometry::area_ratio(Level))
      if (i == 0 || (i > filling && i < filling + w)) {
        uint16_t grey = 0;
        uint64_t colour = 0;
        if (y < h) {
          grey = intensity.read();
          colour = colours.read();
        }
        const ColumnTaps<uint16_t> g = column_taps<Stage>(grey, y >= h, x, slots);
        const ColumnTaps<uint64_t> c = column_taps<Stage>(colour, y >= h, x, slots);
        c0 = box_lane<Stage, 0, 0>(x, y == 0, g);
        c1 = box_lane<Stage, 1, 0>(x, y == 0, c);
        c2 = box_lane<Stage, 2, 1>(x, y == 0, c);
        c3 = box_lane<Stage, 3, 2>(x, y == 0, c);
        c4 = box_lane<Stage, 4, 3>(x, y == 0, c);
        ++x;
      }
      w0.next(c0);
      w1.next(c1);
      w2.next(c2);
      w3.next(c3);
      w4.next(c4);
      if (y >= radius && i >= filling + radius) {
        const uint32_t on = on_contrast<Level>(w0);
        const uint32_t off = off_contrast<Level>(w0);
        const uint32_t green = on_contrast<Level>(w1);
        const uint32_t blue = on_contrast<Level>(w2);
        const uint32_t red = on_contrast<Level>(w3);
        const uint32_t yellow = on_contrast<Level>(w4);
        on_off.write(wide_pair(on, off));
        green_blue.write(wide_pair(green, blue));
        red_yellow.write(wide_pair(red, yellow));
      }
    }
    slots.advance();
  }
}

}  // namespace hls
}  // namespace sailmap
