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

// A loop for the first row, which gives nothing out, one for all others and one behind the last: without
// cases Bambu needs half the time.
template <class Config, int Pair>
void local_maxima(stream<uint64_t>& in, stream<uint32_t>& out, stream<uint8_t>& flags, uint16_t width,
                  uint16_t height) {
  using Rows = MaximaRows<Config, Pair>;
  const int w = geometry::base_side(width);
  const int h = geometry::base_side(height);
  const MaximaColumn outside = {0, 0, 0};
#pragma nounroll
  for (int x = 0; x < w; ++x) {
    SAILMAP_PIPELINE
    Rows::older[x] = 0;
    Rows::newer[x] = raised(in.read());
  }
#pragma nounroll
  for (int y = 1; y < h; ++y) {
    MaximaColumn left = outside;
    MaximaColumn mid = next_row<Config, Pair>(0, raised(in.read()));
#pragma nounroll
    for (int x = 1; x < w; ++x) {
      SAILMAP_PIPELINE
      const MaximaColumn right = next_row<Config, Pair>(x, raised(in.read()));
      out.write(stored_pair<Pair>(lowered(mid.here)));
      flags.write(maxima_flags(left, mid, right));
      left = mid;
      mid = right;
    }
    out.write(stored_pair<Pair>(lowered(mid.here)));
    flags.write(maxima_flags(left, mid, outside));
  }
  MaximaColumn left = outside;
  MaximaColumn mid = next_row<Config, Pair>(0, 0);
#pragma nounroll
  for (int x = 1; x <= w; ++x) {
    SAILMAP_PIPELINE
    const MaximaColumn right = x < w ? next_row<Config, Pair>(x, 0) : outside;
    out.write(stored_pair<Pair>(lowered(mid.here)));
    flags.write(maxima_flags(left, mid, right));
    left = mid;
    mid = right;
  }
}

}  // namespace hls
}  // namespace sailmap
