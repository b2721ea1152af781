// Local maxima of section 7: a pixel > the four neighbours already scanned (three above, one left) and >= the
// other four; outside the image counts as -infinity.
//
// Streams, base level, a pair of maps a word, raster order. In: the exact sums, wider than 16 bits. Out: the
// maps rounded to the 16 bits in which they are stored and leave the front end, and a word of flags a pixel,
// bit l for lane l. Latency: 1 row and 1 column. II 1. The flags are exact; the rounding is that of the
// points intensity_feature and so on. `Pair` says which maps they are.
#pragma once

#include "sailmap/hls/arithmetic.hpp"
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

// Three rows of one column, a pair each, every sum one more than it is: 0 is less than any and stands for
// what lies outside the image.
struct MaximaColumn {
  uint64_t above, here, below;
};
inline uint64_t raised(uint64_t sums) { return sums + wide_pair(1, 1); }
inline uint64_t lowered(uint64_t sums) { return sums - wide_pair(1, 1); }

// Lane `Lane` of the pair at the centre of three columns.
template <int Lane>
inline bool is_local_maximum(const MaximaColumn& left, const MaximaColumn& mid, const MaximaColumn& right) {
  const uint32_t v = wide_lane<Lane>(mid.here);
  return v > wide_lane<Lane>(left.above) && v > wide_lane<Lane>(mid.above) &&
         v > wide_lane<Lane>(right.above) && v > wide_lane<Lane>(left.here) &&
         v >= wide_lane<Lane>(right.here) && v >= wide_lane<Lane>(left.below) &&
         v >= wide_lane<Lane>(mid.below) && v >= wide_lane<Lane>(right.below);
}

inline uint8_t maxima_flags(const MaximaColumn& left, const MaximaColumn& mid, const MaximaColumn& right) {
  return static_cast<uint8_t>((is_local_maximum<0>(left, mid, right) ? 1 : 0) |
                              (is_local_maximum<1>(left, mid, right) ? 2 : 0));
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
  const MaximaColumn column = {Rows::older[x], Rows::newer[x], below};
  Rows::older[x] = column.here;
  Rows::newer[x] = below;
  return column;
}

// The pixel that goes out, `mid`, at column `at` of its row, and its neighbours.
template <class Config, int Pair>
struct MaximaWindow {
  MaximaColumn left, mid, right;
  int at;

  void write(stream<uint32_t>& out, stream<uint8_t>& flags, int width) const {
    const MaximaColumn outside = {0, 0, 0};
    out.write(stored_pair<Pair>(lowered(mid.here)));
    flags.write(maxima_flags(at == 0 ? outside : left, mid, at + 1 == width ? outside : right));
  }
  void next(const MaximaColumn& column, int width) {
    left = mid;
    mid = right;
    right = column;
    at = at + 1 == width ? 0 : at + 1;
  }
};

// A loop for the first row, which gives nothing out, one for all others and one behind the last: without
// cases Bambu needs half the time. From the second row on rows run on into each other, two pixels behind what
// is read: all that a turn writes is there when it begins, so that it need not wait for what it reads.
template <class Config, int Pair>
void local_maxima(stream<uint64_t>& in, stream<uint32_t>& out, stream<uint8_t>& flags, uint16_t width,
                  uint16_t height) {
  using Rows = MaximaRows<Config, Pair>;
  const int w = geometry::base_side(width);
  const int h = geometry::base_side(height);
#pragma nounroll
  for (int x = 0; x < w; ++x) {
    SAILMAP_PIPELINE
    Rows::older[x] = 0;
    Rows::newer[x] = raised(in.read());
  }
  MaximaWindow<Config, Pair> window = MaximaWindow<Config, Pair>();
  window.at = w - 2;
  int x = 0;
#pragma nounroll
  for (; x < 2; ++x) window.next(next_row<Config, Pair>(x, raised(in.read())), w);
  const int pixels = w * (h - 1);
#pragma nounroll
  for (int i = 2; i < pixels; ++i) {
    SAILMAP_PIPELINE
    window.write(out, flags, w);
    window.next(next_row<Config, Pair>(x, raised(in.read())), w);
    x = x + 1 == w ? 0 : x + 1;
  }
  const MaximaColumn outside = {0, 0, 0};
#pragma nounroll
  for (x = 0; x < w + 2; ++x) {
    SAILMAP_PIPELINE
    window.write(out, flags, w);
    window.next(x < w ? next_row<Config, Pair>(x, 0) : outside, w);
  }
}

}  // namespace hls
}  // namespace sailmap
