// The arithmetic of the pyramid, spec section 3: separable binomial [1 4 6 4 1]/16, even rows and columns
// kept, edges replicated. The stages are in reduce_pixels.hpp and reduce_lanes.hpp.
//
// Vertically each output needs five rows, of which an even one serves three outputs and an odd one two. So
// instead of rows, two partial sums are kept a column: `open`, the older output that still lacks rows, and
// `next`, the one after. Maximum error of a level against the exact one: accuracy::level_error; of
// one reduction: half a unit of the
// output.
#pragma once

#include "sailmap/hls/arithmetic.hpp"
#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

// The vertical sums of one column of one channel, packed for a line buffer: `open` low, `next` high.
// Each is a part of 256 samples.
constexpr int sum_bits = formats::colour::word + 8;
static_assert(formats::intensity::word <= formats::colour::word, "no sum of the intensity loses a bit");
inline uint32_t open_sum(uint64_t sums) { return narrow<sum_bits>(wide_lane<0>(sums)); }
inline uint32_t next_sum(uint64_t sums) { return narrow<sum_bits>(wide_lane<1>(sums)); }
inline uint64_t pack_sums(uint32_t open, uint32_t next) { return static_cast<uint64_t>(next) << 32 | open; }

// Where a row stands in the vertical sums.
struct RowKind {
  bool first;
  bool even;
  bool last;
  // Whether a row of the coarser level is complete with this row. The last one is not, even where its rows
  // are all there: it follows the frame, so that the rows of the coarser level come every second row and
  // never oftener.
  bool emits() const { return even && !first; }
};

inline RowKind row_kind(int row, int height) {
  RowKind kind = {false, false, false};
  kind.first = row == 0;
  kind.even = (row & 1) == 0;
  kind.last = row + 1 == height;
  return kind;
}

// The sums after one more row, whose horizontal sum is `row`. The first row stands for the two above it as
// well, the last for the two below: 1+4+6 = 11 of an output that it is the middle of, 4+1 more of one that
// it is below. Selections of shifts and adds, which no tool makes multipliers or branches of.
inline uint64_t add_row(uint64_t sums, uint32_t row, RowKind kind) {
  const uint32_t open = open_sum(sums);
  const uint32_t next = next_sum(sums);
  const uint32_t four = 4 * row;
  const uint32_t older = kind.even ? next : open;
  const uint32_t before = kind.first ? 0 : older;
  const uint32_t own = four + (kind.even ? 2 * row : 0);
  const uint32_t edge = row + (kind.even ? four : 0);
  const uint32_t beyond = kind.first || kind.last ? edge : 0;
  const uint32_t younger = kind.even ? 0 : next;
  const uint32_t share = kind.even ? row : four;
  return pack_sums(narrow<sum_bits>(before + own + beyond), narrow<sum_bits>(younger + share));
}

// The complete sum that a row with emits() yields, from the sums before it.
inline uint32_t completed(uint64_t sums, uint32_t row) { return narrow<sum_bits>(open_sum(sums) + row); }

// A sum of weight 256 of level `Fine` as a sample of the next level; Channel 0 is the intensity.
template <int Fine, int Channel>
inline uint16_t reduced(uint32_t sum) {
  return Fine == 0 && Channel == 0 ? reduce_grey(sum) : reduce(sum);
}

inline uint32_t binomial(uint32_t a, uint32_t b, uint32_t c, uint32_t d, uint32_t e) {
  return a + e + 4 * (b + d) + 6 * c;
}

// The line buffer of one channel and output lane; one per stage.
template <class Stage, int Channel, int Lane>
struct ColumnSums {
  static uint64_t sums[Stage::columns];
};
template <class Stage, int Channel, int Lane>
SAILMAP_MEMORY uint64_t ColumnSums<Stage, Channel, Lane>::sums[Stage::columns];

// Adds `row` to column x; returns the sample that it completes (to be used when the row emits).
template <class Stage, int Channel, int Lane>
inline uint16_t add_to_column(int x, uint32_t row, RowKind kind) {
  const uint64_t before = ColumnSums<Stage, Channel, Lane>::sums[x];
  ColumnSums<Stage, Channel, Lane>::sums[x] = add_row(before, row, kind);
  return reduced<Stage::fine, Channel>(completed(before, row));
}

// The sample of the last row, which the sums hold complete after the frame.
template <class Stage, int Channel, int Lane>
inline uint16_t last_of_column(int x) {
  return reduced<Stage::fine, Channel>(open_sum(ColumnSums<Stage, Channel, Lane>::sums[x]));
}

}  // namespace hls
}  // namespace sailmap
