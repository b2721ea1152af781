// Local maxima of section 7: a pixel > the four neighbours already scanned (three above, one left) and >= the
// other four; outside the image counts as -infinity.
//
// Streams, base level, a pair of maps a word, raster order. In: the exact sums, wider than 16 bits. Out: the
// maps rounded to the 16 bits in which they are stored and leave the front end, and a word of flags a pixel:
// bit l for lane l, `start_of_frame`, `last_but_one`. The conspicuity maps come twice (peaks.hpp). Latency: 1
// row and 2 columns. II 1. The flags are exact; the rounding is that of the points intensity_feature and so
// on. `Pair` says which maps they are.
#pragma once

#include "sailmap/hls/arithmetic.hpp"
#include "sailmap/hls/formats.hpp"
#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/kinds.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

// Every pixel is compared with each neighbour once, by the later of the two: the earlier one holds as a
// maximum when the later one is not greater, the later one when it is. So a pixel goes along as a word: its
// sum, in the bits of the widest, since more would cost registers and comparators, and above it whether it
// still holds.
constexpr int maxima_sum_bits = formats::colour_conspicuity_sum::word;
static_assert(formats::intensity_sum::word <= maxima_sum_bits &&
                  formats::colour_sum::word <= maxima_sum_bits &&
                  formats::orientation_sum::word <= maxima_sum_bits &&
                  formats::intensity_conspicuity_sum::word <= maxima_sum_bits &&
                  formats::orientation_conspicuity_sum::word <= maxima_sum_bits,
              "no sum loses a bit");
constexpr int maxima_word_bits = maxima_sum_bits + 1;
constexpr uint32_t holds = uint32_t{1} << maxima_sum_bits;

// A row: the newest up to the newest column, behind it the one above.
template <class Config, int Pair>
struct MaximaRow {
  static uint64_t words[Config::level_width(geometry::base_level)];
};
template <class Config, int Pair>
SAILMAP_MEMORY uint64_t MaximaRow<Config, Pair>::words[Config::level_width(geometry::base_level)];

inline uint32_t maxima_sum(uint32_t word) { return narrow<maxima_sum_bits>(word); }

// The newest pixel of one map and the neighbours before it: left in its row, and the three above.
struct MaximaPixels {
  uint32_t newest, left, above_left, above, above_right;
};

// Where a pixel has no neighbours.
struct MaximaEdges {
  bool first_column, last_column, first_row;
};

template <int Lane>
inline MaximaPixels maxima_lane(uint64_t newest, uint64_t left, uint64_t above_left, uint64_t above,
                                uint64_t above_right) {
  const MaximaPixels p = {wide_lane<Lane>(newest), wide_lane<Lane>(left), wide_lane<Lane>(above_left),
                          wide_lane<Lane>(above), wide_lane<Lane>(above_right)};
  return p;
}

// Compares the newest pixel, a sum alone, with those before it.
SAILMAP_INLINED MaximaPixels compared(const MaximaPixels& p, const MaximaEdges& at) {
  const bool over_left = p.newest > maxima_sum(p.left);
  const bool over_above_left = p.newest > maxima_sum(p.above_left);
  const bool over_above = p.newest > maxima_sum(p.above);
  const bool over_above_right = p.newest > maxima_sum(p.above_right);
  const bool over_row = at.first_column || over_left;
  const bool over_rows = at.first_row || ((at.first_column || over_above_left) && over_above &&
                                          (at.last_column || over_above_right));
  MaximaPixels out = p;
  out.newest = p.newest | (over_row && over_rows ? holds : 0U);
  out.left = p.left & ~(!at.first_column && over_left ? holds : 0U);
  out.above_left = p.above_left & ~(!at.first_column && over_above_left ? holds : 0U);
  out.above = p.above & ~(over_above ? holds : 0U);
  out.above_right = p.above_right & ~(!at.last_column && over_above_right ? holds : 0U);
  return out;
}

// C_O is alone: of a second map there is nothing to compare or to keep.
template <int Pair>
SAILMAP_INLINED MaximaPixels second_of_pair(const MaximaPixels& p) {
  constexpr uint32_t all = Pair == orientation_pair ? 0 : ~uint32_t{0};
  const MaximaPixels out = {p.newest & all, p.left & all, p.above_left & all, p.above & all,
                            p.above_right & all};
  return out;
}

// The pair in the words of the stores.
template <int Pair>
inline uint32_t stored_pair(uint64_t words) {
  const uint32_t a = maxima_sum(wide_lane<0>(words));
  const uint32_t b = maxima_sum(wide_lane<1>(words));
  return Pair == intensity_colour_pair ? pack(intensity_conspicuity(a), colour_conspicuity(b))
         : Pair == orientation_pair    ? pack(orientation_conspicuity(a), 0)
                                       : pack(feature(a), feature(b));
}

// The flags of a pair; `mark` among them where a store looks for it.
template <int Pair>
inline uint8_t marked(uint64_t words, uint8_t mark) {
  return static_cast<uint8_t>(((wide_lane<0>(words) & holds) != 0 ? 1 : 0) |
                              ((wide_lane<1>(words) & holds) != 0 ? 2 : 0) | (marks_frames(Pair) ? mark : 0));
}

// One loop, in which rows run on into each other, from the first pixel to the last one out: reading starts a
// row and two pixels before writing. All that a turn writes is there when it begins, so that it need not wait
// for what it reads. Behind the last row come zeros, which no pixel is less than.
template <class Config, int Pair>
SAILMAP_INLINED void local_maxima_of_pass(stream<uint64_t>& in, stream<uint32_t>& out, stream<uint8_t>& flags,
                                          int w, int h) {
  uint64_t* const row = MaximaRow<Config, Pair>::words;
  constexpr int behind = 2;
  const int end_of_reading = w * h;
  const int start_of_writing = w + behind;
  uint64_t left = 0;
  uint64_t above_left = 0;
  uint64_t above = 0;
  uint64_t done = 0;
  // Of the first pixel out; and when nothing is read any more, of the one before the last: the second time
  // that x is 0.
  uint8_t mark = start_of_frame;
  int x = 0;
#pragma nounroll
  for (int i = 0; i < end_of_reading + start_of_writing; ++i) {
    SAILMAP_PIPELINE
    const bool reads = i < end_of_reading;
    const bool writes = i >= start_of_writing;
    uint64_t newest = 0;
    if (reads && writes) {
      out.write(stored_pair<Pair>(done));
      newest = in.read();
      flags.write(marked<Pair>(done, mark));
      mark = 0;
    } else if (reads) {
      newest = in.read();
    } else {
      out.write(stored_pair<Pair>(done));
      flags.write(marked<Pair>(done, x == 0 ? mark : 0));
      mark = last_but_one;
    }
    newest = narrow_pair<maxima_sum_bits>(newest);
    const MaximaEdges at = {x == 0, x + 1 == w, i < w};
    const uint64_t above_right = narrow_pair<maxima_word_bits>(row[at.last_column ? 0 : x + 1]);
    const MaximaPixels a = compared(maxima_lane<0>(newest, left, above_left, above, above_right), at);
    const MaximaPixels b =
        second_of_pair<Pair>(compared(maxima_lane<1>(newest, left, above_left, above, above_right), at));
    row[at.first_column ? w - 1 : x - 1] = wide_pair(a.left, b.left);
    done = wide_pair(a.above_left, b.above_left);
    above_left = wide_pair(a.above, b.above);
    above = wide_pair(a.above_right, b.above_right);
    left = wide_pair(a.newest, b.newest);
    x = at.last_column ? 0 : x + 1;
  }
}

template <class Config, int Pair>
void local_maxima(stream<uint64_t>& in, stream<uint32_t>& out, stream<uint8_t>& flags, uint16_t width,
                  uint16_t height) {
  const int w = Config::columns(width, geometry::base_level);
  const int h = Config::rows(height, geometry::base_level);
#pragma nounroll
  for (int pass = 0; pass < passes_of_pair(Pair); ++pass) {
    local_maxima_of_pass<Config, Pair>(in, out, flags, w, h);
  }
}

}  // namespace hls
}  // namespace sailmap
