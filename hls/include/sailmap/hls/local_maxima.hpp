// Local maxima of section 7: a pixel > the four neighbours already scanned (three above, one left) and >= the
// other four; outside the image counts as -infinity.
//
// Streams, base level, a pair of maps a word, raster order. In: the exact sums, wider than 16 bits. Out: the
// maps rounded to the 16 bits in which they are stored and leave the front end, and a word of flags a pixel,
// bit l for lane l. Latency: 1 row and 2 columns. II 1. The flags are exact; the rounding is that of the
// points intensity_feature and so on. `Pair` says which maps they are.
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

// The last two rows; `newer` is the one above the newest.
template <class Config, int Pair>
struct MaximaRows {
  static uint64_t newer[Config::level_width(geometry::base_level)];
  static uint64_t older[Config::level_width(geometry::base_level)];
};
template <class Config, int Pair>
SAILMAP_MEMORY uint64_t MaximaRows<Config, Pair>::newer[Config::level_width(geometry::base_level)];
template <class Config, int Pair>
SAILMAP_MEMORY uint64_t MaximaRows<Config, Pair>::older[Config::level_width(geometry::base_level)];

// No sum has more than 22 bits, and none loses any by the mask, which tells a tool how wide its registers and
// comparisons need be.
constexpr uint32_t sum_bits = (1U << formats::colour_conspicuity_sum::word) - 1;
inline uint64_t masked(uint64_t sums) { return sums & wide_pair(sum_bits, sum_bits); }

// Three rows of one column, a pair each; 0 `below` the last row.
struct MaximaColumn {
  uint64_t above, here, below;
};

// Where a pixel has no neighbours.
struct MaximaEdges {
  bool first_column, last_column, first_row;
};

// Lane `Lane` of the pair at the centre of three columns. No sum is less than the 0 below the last row.
template <int Lane>
SAILMAP_INLINED bool is_local_maximum(const MaximaColumn& left, const MaximaColumn& mid,
                                      const MaximaColumn& right, const MaximaEdges& at) {
  const uint32_t v = wide_lane<Lane>(mid.here);
  const bool over_left = (at.first_row || v > wide_lane<Lane>(left.above)) &&
                         v > wide_lane<Lane>(left.here) && v >= wide_lane<Lane>(left.below);
  const bool over_mid = (at.first_row || v > wide_lane<Lane>(mid.above)) && v >= wide_lane<Lane>(mid.below);
  const bool over_right = (at.first_row || v > wide_lane<Lane>(right.above)) &&
                          v >= wide_lane<Lane>(right.here) && v >= wide_lane<Lane>(right.below);
  return (at.first_column || over_left) && over_mid && (at.last_column || over_right);
}

SAILMAP_INLINED uint8_t maxima_flags(const MaximaColumn& left, const MaximaColumn& mid,
                                     const MaximaColumn& right, const MaximaEdges& at) {
  return static_cast<uint8_t>((is_local_maximum<0>(left, mid, right, at) ? 1 : 0) |
                              (is_local_maximum<1>(left, mid, right, at) ? 2 : 0));
}

// The pair in the words of the stores.
template <int Pair>
inline uint32_t stored_pair(uint64_t sums) {
  const uint32_t a = wide_lane<0>(sums);
  const uint32_t b = wide_lane<1>(sums);
  return Pair == intensity_colour_pair ? pack(intensity_conspicuity(a), colour_conspicuity(b))
         : Pair == orientation_pair    ? pack(orientation_conspicuity(a), 0)
                                       : pack(feature(a), feature(b));
}

// Column x with one row more, `below`.
template <class Config, int Pair>
inline MaximaColumn next_row(int x, uint64_t below) {
  using Rows = MaximaRows<Config, Pair>;
  const MaximaColumn column = {masked(Rows::older[x]), masked(Rows::newer[x]), below};
  Rows::older[x] = column.here;
  Rows::newer[x] = below;
  return column;
}

// The pixel that goes out, `mid`, at column `x` of its row, and its neighbours.
template <class Config, int Pair>
struct MaximaWindow {
  MaximaColumn left, mid, right;
  int x;

  SAILMAP_INLINED void write(stream<uint32_t>& out, stream<uint8_t>& flags, int width, bool first_row) const {
    const MaximaEdges at = {x == 0, x + 1 == width, first_row};
    out.write(stored_pair<Pair>(mid.here));
    flags.write(maxima_flags(left, mid, right, at));
  }
  void next(const MaximaColumn& column, int width) {
    left = mid;
    mid = right;
    right = column;
    x = x + 1 == width ? 0 : x + 1;
  }
};

// A loop for the first row, which gives nothing out, one for all others and one behind the last: without
// cases Bambu needs half the time. From the second row on rows run on into each other, two pixels behind what
// is read: all that a turn writes is there when it begins, so that it need not wait for what it reads.
template <class Config, int Pair>
void local_maxima(stream<uint64_t>& in, stream<uint32_t>& out, stream<uint8_t>& flags, uint16_t width,
                  uint16_t height) {
  using Rows = MaximaRows<Config, Pair>;
  constexpr int behind = 2;
  const int w = geometry::base_side(width);
  const int h = geometry::base_side(height);
#pragma nounroll
  for (int x = 0; x < w; ++x) {
    SAILMAP_PIPELINE
    Rows::newer[x] = masked(in.read());
  }
  MaximaWindow<Config, Pair> window = MaximaWindow<Config, Pair>();
  window.x = w - behind;
  int x = 0;
#pragma nounroll
  for (; x < behind; ++x) window.next(next_row<Config, Pair>(x, masked(in.read())), w);
  const int pixels = w * (h - 1);
#pragma nounroll
  for (int i = behind; i < pixels; ++i) {
    SAILMAP_PIPELINE
    window.write(out, flags, w, i < w + behind);
    window.next(next_row<Config, Pair>(x, masked(in.read())), w);
    x = x + 1 == w ? 0 : x + 1;
  }
  const MaximaColumn outside = {0, 0, 0};
#pragma nounroll
  for (x = 0; x < w + behind; ++x) {
    SAILMAP_PIPELINE
    window.write(out, flags, w, false);
    window.next(x < w ? next_row<Config, Pair>(x, 0) : outside, w);
  }
}

}  // namespace hls
}  // namespace sailmap
