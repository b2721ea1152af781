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

// The vertical sums of one column of one channel, packed for a line buffer: `open` low, `next` above it.
// Each is a part of 256 samples.
constexpr int sum_bits = formats::colour::word + 8;
static_assert(formats::intensity::word <= formats::colour::word, "no sum of the intensity loses a bit");
inline uint32_t open_sum(uint64_t sums) { return narrow<sum_bits>(static_cast<uint32_t>(sums)); }
inline uint32_t next_sum(uint64_t sums) { return narrow<sum_bits>(static_cast<uint32_t>(sums >> sum_bits)); }
inline uint64_t pack_sums(uint32_t open, uint32_t next) {
  return static_cast<uint64_t>(next) << sum_bits | open;
}
static_assert(2 * sum_bits + formats::colour::word <= 64, "the sums and a sample fit in a word");

// Where a row stands in the vertical sums. Behind the last row comes one without pixels, for the sums that
// are complete by then.
namespace row_kind {
constexpr uint32_t even = 1, first = 2, edge = 4, behind = 8;
inline uint32_t of(int row, int height) {
  return ((row & 1) == 0 ? even : 0U) | (row == 0 ? first : 0U) |
         (row == 0 || row + 1 == height ? edge : 0U) | (row == height ? behind : 0U);
}
// Whether a row of the coarser level is complete with this row. The last one is not, even where its rows
// are all there: it follows the frame, so that the rows of the coarser level come every second row and
// never oftener.
inline bool emits(uint32_t kind) { return (kind & behind) != 0 || (kind & (even | first)) == even; }
}  // namespace row_kind

// Five neighbours in a row.
struct FiveTaps {
  uint16_t a, b, c, d, e;
};

// A sum of weight 256 of level `Fine` as a sample of the next level; Channel 0 is the intensity.
template <int Fine, int Channel>
inline uint16_t reduced(uint32_t sum) {
  return Fine == 0 && Channel == 0 ? reduce_grey(sum) : reduce(sum);
}

// One column of one row: the sums after it, and above them the sample that it completes (to be used when the
// row emits). The first row stands for the two above it as well, the last for the two below: 1+4+6 = 11 of an
// output that it is the middle of, 4+1 more of one that it is below. Selections of shifts and adds, which no
// tool makes multipliers or branches of.
template <int Fine, int Channel>
inline uint64_t column_after(uint64_t sums, uint16_t a, uint16_t b, uint16_t c, uint16_t d, uint16_t e,
                             uint32_t kind) {
  constexpr int bits = Fine == 0 && Channel == 0 ? formats::grey_sum::word : formats::colour::word;
  const bool even = (kind & row_kind::even) != 0;
  const bool edge = (kind & row_kind::edge) != 0;
  const uint32_t centre = narrow<bits>(c);
  const uint32_t row =
      narrow<bits>(a) + narrow<bits>(e) + 2 * centre + 4 * (narrow<bits>(b) + narrow<bits>(d) + centre);
  const uint32_t open = narrow<bits + 8>(open_sum(sums));
  const uint32_t next = narrow<bits + 8>(next_sum(sums));
  const uint32_t older = even ? next : open;
  const uint32_t before = (kind & row_kind::first) != 0 ? 0 : older;
  const uint32_t own = (even && edge ? 8 * row : 4 * row) + (even ? 2 * row : 0) + (edge ? row : 0);
  const uint32_t younger = even ? 0 : next;
  const uint32_t share = even ? row : 4 * row;
  const uint32_t completed = narrow<bits + 8>(open + ((kind & row_kind::behind) != 0 ? 0 : row));
  return pack_sums(narrow<bits + 8>(before + own), narrow<bits + 8>(younger + share)) |
         static_cast<uint64_t>(reduced<Fine, Channel>(completed)) << 2 * sum_bits;
}

inline uint64_t sums_of(uint64_t after) { return after & ((uint64_t{1} << 2 * sum_bits) - 1); }
inline uint16_t sample_of(uint64_t after) { return static_cast<uint16_t>(after >> 2 * sum_bits); }

// The same, for channels that take turns.
template <int Fine, int Channel>
SAILMAP_SHARED uint64_t shared_column(uint64_t sums, uint16_t a, uint16_t b, uint16_t c, uint16_t d,
                                      uint16_t e, uint32_t kind) {
  return column_after<Fine, Channel>(sums, a, b, c, d, e, untagged<2 * Fine + Channel>(kind));
}

// The line buffer of one channel and output lane; one per stage.
template <class Stage, int Channel, int Lane>
struct ColumnSums {
  static uint64_t sums[Stage::columns];
};
template <class Stage, int Channel, int Lane>
SAILMAP_MEMORY uint64_t ColumnSums<Stage, Channel, Lane>::sums[Stage::columns];

// Adds a row's five pixels around column x; returns the sample that they complete.
template <class Stage, int Channel, int Lane>
inline uint16_t add_to_column(int x, const FiveTaps& p, uint32_t kind) {
  const uint64_t before = ColumnSums<Stage, Channel, Lane>::sums[x];
  const uint64_t after = column_after<Stage::fine, Channel>(before, p.a, p.b, p.c, p.d, p.e, kind);
  ColumnSums<Stage, Channel, Lane>::sums[x] = sums_of(after);
  return sample_of(after);
}

// The sample of the last row, which the sums hold complete after the frame.
template <class Stage, int Channel, int Lane>
inline uint16_t last_of_column(int x) {
  return reduced<Stage::fine, Channel>(open_sum(ColumnSums<Stage, Channel, Lane>::sums[x]));
}

}  // namespace hls
}  // namespace sailmap
