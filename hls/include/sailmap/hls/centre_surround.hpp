// Centre-surround contrast, spec section 4: centre against the means of the 7x7 and the 15x15 window.
//
// Streams, level `Level`, one pixel a word, raster order. In: intensity; green, blue, red, yellow as lanes.
// Out: intensity on and off as lanes; the four colours' on as lanes. Formats: intensity, colour in;
// intensity_contrast, colour_contrast out. Latency: 7 rows and 10 columns. II 1 on the base level, 4 and 16
// on the coarser ones. Rows stand alone: a row takes 7 words of filling and 10 of flushing. Maximum error
// against the exact contrast of the exact level: accuracy::contrast_error; of the same samples: half a unit
// of the output.
//
// Box sums run: a column's sum takes in one pixel and lets one go a row, a window's sum one column sum a
// column. The pixels that enter and leave are those of the newest row and of 4, 7 (the centre), 11 and 15
// rows before it; one row memory after the other holds them, each with one load and one store a pixel.
#pragma once

#include "sailmap/hls/arithmetic.hpp"
#include "sailmap/hls/delays.hpp"
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

// The first column of a row stands for those before it: it goes in so much oftener.
constexpr int surround_filling = geometry::surround_radius_large;

template <class Config, int Level>
struct CentreSurround {
  static constexpr int columns = Config::level_width(Level);
};

// `Rows` rows of words, and one more for turns without a new column; Segment tells the memories of a stage
// apart.
template <class Stage, int Segment, class Word, int Rows>
struct RowMemory {
  static constexpr int none = Rows * Stage::columns;
  static Word words[none + 1];
};
template <class Stage, int Segment, class Word, int Rows>
SAILMAP_MEMORY Word
    RowMemory<Stage, Segment, Word, Rows>::words[RowMemory<Stage, Segment, Word, Rows>::none + 1];

// Sums of the columns of one channel: over 15 rows low, over 7 rows high; and a word for turns without.
template <class Stage, int Channel>
struct BoxColumns {
  static uint64_t sums[Stage::columns + 1];
};
template <class Stage, int Channel>
SAILMAP_MEMORY uint64_t BoxColumns<Stage, Channel>::sums[Stage::columns + 1];

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

// Where a turn works: column x, and whether it takes one in. A turn that does not stores where nobody looks.
struct ColumnPlace {
  int x;
  bool takes;
};

template <class Stage, int Segment, class Word, int Rows>
inline Word pass_on(int slot, ColumnPlace at, Word in) {
  using Memory = RowMemory<Stage, Segment, Word, Rows>;
  const Word out = Memory::words[slot + at.x];
  Memory::words[at.takes ? slot + at.x : Memory::none] = in;
  return out;
}

// Before the frame stands its first row, over and over: the first memory still has it in slot 0 when it is
// needed, and what a later memory is given in its first rows is that row already.
template <class Stage, class Word>
inline ColumnTaps<Word> column_taps(Word read, bool is_read, ColumnPlace at, const RowSlots& slots) {
  using First = RowMemory<Stage, 1, Word, to_small>;
  ColumnTaps<Word> taps = ColumnTaps<Word>();
  const Word again = First::words[slots.first_before + at.x];
  taps.newest = is_read ? read : again;
  const Word a = First::words[(slots.row < to_small ? 0 : slots.first) + at.x];
  taps.small_in = slots.row == 0 ? taps.newest : a;
  First::words[at.takes ? slots.first + at.x : First::none] = taps.newest;
  const Word b = pass_on<Stage, 2, Word, to_centre>(slots.second, at, taps.small_in);
  taps.centre = slots.row < to_centre ? taps.small_in : b;
  const Word c = pass_on<Stage, 3, Word, to_end>(slots.third, at, taps.centre);
  taps.small_out = slots.row < to_end ? taps.centre : c;
  const Word d = pass_on<Stage, 4, Word, to_small>(slots.fourth, at, taps.small_out);
  taps.large_out = slots.row < to_small ? taps.small_out : d;
  return taps;
}

// Sums of up to 16 and 8 samples.
constexpr int large_column_bits = formats::intensity::word + 4;
constexpr int small_column_bits = formats::intensity::word + 3;
static_assert(formats::colour::word <= formats::intensity::word &&
                  formats::colour_box_large::word <= formats::intensity_box_large::word &&
                  formats::colour_box_small::word <= formats::intensity_box_small::word,
              "no sum of a colour loses a bit");

// Column sums over the large and the small window, and the centre pixel, of one channel.
struct BoxColumn {
  uint32_t large, small;
  uint16_t centre;
};

// The first row stands for all above it. Selections of values already there rather than cases, so that loads
// need not wait for them.
template <class Stage, int Channel>
inline BoxColumn box_column(ColumnPlace at, bool first_row, uint16_t newest, uint16_t small_in,
                            uint16_t centre, uint16_t small_out, uint16_t large_out) {
  uint64_t* const sums = BoxColumns<Stage, Channel>::sums;
  const uint64_t stored = sums[at.x];
  const uint64_t before = first_row ? 0 : stored;
  const uint32_t large_enters = first_row ? 16U * newest : newest + 0U;
  const uint32_t large_leaves = first_row ? newest : large_out;
  const uint32_t small_enters = first_row ? 8U * newest : small_in + 0U;
  const uint32_t small_leaves = first_row ? newest : small_out;
  static_assert(large_side == 15 && small_side == 7, "the first row weighs 16 - 1 and 8 - 1");
  BoxColumn out = {0, 0, centre};
  out.large = narrow<large_column_bits>(wide_lane<0>(before) + large_enters - large_leaves);
  out.small = narrow<small_column_bits>(wide_lane<1>(before) + small_enters - small_leaves);
  sums[at.takes ? at.x : Stage::columns] = static_cast<uint64_t>(out.small) << 32 | out.large;
  return out;
}

// The newest column of a channel: `before` where a turn takes none.
template <class Stage, int Channel, int Index, class Word>
inline BoxColumn box_lane(ColumnPlace at, bool first_row, const ColumnTaps<Word>& taps,
                          const BoxColumn& before) {
  const BoxColumn column = box_column<Stage, Channel>(
      at, first_row, lane<Index>(taps.newest), lane<Index>(taps.small_in), lane<Index>(taps.centre),
      lane<Index>(taps.small_out), lane<Index>(taps.large_out));
  BoxColumn out = {0, 0, 0};
  out.large = at.takes ? column.large : before.large;
  out.small = at.takes ? column.small : before.small;
  out.centre = at.takes ? column.centre : before.centre;
  return out;
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
    large =
        narrow<formats::intensity_box_large::word>(large + column.large - large_columns.push(column.large));
    const uint32_t enters = until_small.push(column.small);
    small = narrow<formats::intensity_box_small::word>(small + enters - small_columns.push(enters));
    centre = centres.push(column.centre);
  }
};

// contrast() of the centre. On the coarser levels there is time to take one channel after the other through
// it, in Bambu one a cycle (SAILMAP_SHARED).
template <int Level, bool IsBase = Level == geometry::base_level>
struct Contrasts {
  static uint32_t of(uint16_t centre, uint32_t small, uint32_t large, bool off) {
    return contrast(centre, static_cast<int32_t>(small), static_cast<int32_t>(large), off ? -1 : 1);
  }
};
template <int Level>
SAILMAP_SHARED uint32_t shared_contrast(uint16_t centre, uint32_t small, uint32_t large, uint32_t kind) {
  const auto small_sum = static_cast<int32_t>(narrow<formats::intensity_box_small::word>(small));
  const auto large_sum = static_cast<int32_t>(narrow<formats::intensity_box_large::word>(large));
  const bool off = (untagged<Level>(kind) & 1U) != 0;
  return contrast(centre, small_sum, large_sum, off ? -1 : 1);
}
template <int Level>
struct Contrasts<Level, false> {
  static uint32_t of(uint16_t centre, uint32_t small, uint32_t large, bool off) {
    return shared_contrast<Level>(centre, small, large, tagged<Level>(off ? 1 : 0));
  }
};

template <int Level>
inline uint32_t on_contrast(const BoxWindow& w) {
  return Contrasts<Level>::of(w.centre, w.small, w.large, false);
}
template <int Level>
inline uint32_t off_contrast(const BoxWindow& w) {
  return Contrasts<Level>::of(w.centre, w.small, w.large, true);
}

// The words that a turn has for the next one to write.
struct SurroundWords {
  uint64_t on_off, green_blue, red_yellow;
};

// A turn reads, writes, or both; each in one place for a case, since a case is what costs Bambu time. Nothing
// that is written waits for what is read.
template <class Config, int Level>
void centre_surround(stream<uint16_t>& intensity, stream<uint64_t>& colours, stream<uint64_t>& on_off,
                     stream<uint64_t>& green_blue, stream<uint64_t>& red_yellow, uint16_t width,
                     uint16_t height) {
  using Stage = CentreSurround<Config, Level>;
  constexpr int radius = geometry::surround_radius_large;
  constexpr int filling = surround_filling;
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
  SurroundWords words = {0, 0, 0};
#pragma nounroll
  for (int y = 0; y < h + radius; ++y) {
    // Bounds rather than conditions that the whole row shares, of which a compiler makes loops of their own.
    const int end_of_reading = y < h ? filling + w : 0;
    const int end = filling + w + radius + surround_turns;
    const int start_of_writing = y < radius ? end : filling + radius + surround_turns;
    ColumnPlace at = {0, false};
#pragma nounroll
    for (int i = 0; i < end; ++i) {
      SAILMAP_PIPELINE_II(geometry::area_ratio(Level))
      at.takes = i == 0 || (i > filling && i < filling + w);
      const bool reads = at.takes && i < end_of_reading;
      const bool writes = i >= start_of_writing;
      uint16_t grey = 0;
      uint64_t colour = 0;
      if (reads && writes) {
        on_off.write(words.on_off);
        grey = intensity.read();
        colour = colours.read();
        green_blue.write(words.green_blue);
        red_yellow.write(words.red_yellow);
      } else if (reads) {
        grey = intensity.read();
        colour = colours.read();
      } else if (writes) {
        on_off.write(words.on_off);
        green_blue.write(words.green_blue);
        red_yellow.write(words.red_yellow);
      }
      words.on_off = wide_pair(on_contrast<Level>(w0), off_contrast<Level>(w0));
      words.green_blue = wide_pair(on_contrast<Level>(w1), on_contrast<Level>(w2));
      words.red_yellow = wide_pair(on_contrast<Level>(w3), on_contrast<Level>(w4));
      w0.next(c0);
      w1.next(c1);
      w2.next(c2);
      w3.next(c3);
      w4.next(c4);
      const ColumnTaps<uint16_t> g = column_taps<Stage>(grey, reads, at, slots);
      const ColumnTaps<uint64_t> c = column_taps<Stage>(colour, reads, at, slots);
      c0 = box_lane<Stage, 0, 0>(at, y == 0, g, c0);
      c1 = box_lane<Stage, 1, 0>(at, y == 0, c, c1);
      c2 = box_lane<Stage, 2, 1>(at, y == 0, c, c2);
      c3 = box_lane<Stage, 3, 2>(at, y == 0, c, c3);
      c4 = box_lane<Stage, 4, 3>(at, y == 0, c, c4);
      at.x += at.takes ? 1 : 0;
    }
    slots.advance();
  }
}

}  // namespace hls
}  // namespace sailmap
