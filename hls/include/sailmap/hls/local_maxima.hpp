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

template <class Config, int Pair>
void local_maxima(stream<uint64_t>& in, stream<uint32_t>& out, stream<uint8_t>& flags, uint16_t width,
                  uint16_t height) {
  using Rows = MaximaRows<Config, Pair>;
  const int w = geometry::base_side(width);
  const int h = geometry::base_side(height);
#pragma nounroll
  for (int y = 0; y <= h; ++y) {
    MaximaColumn left = {0, 0, 0};
    MaximaColumn mid = left;
    MaximaColumn right = left;
#pragma nounroll
    for (int x = 0; x <= w; ++x) {
      SAILMAP_PIPELINE
      left = mid;
      mid = right;
      right.above = 0;
      right.here = 0;
      right.below = 0;
      if (x < w) {
        // Before row 0 the memories still hold another frame; what row 0 leaves in `older` is 0.
        const uint64_t above = Rows::older[x];
        const uint64_t here = Rows::newer[x];
        right.above = y == 0 ? 0 : above;
        right.here = y == 0 ? 0 : here;
        if (y < h) right.below = raised(in.read());
        Rows::older[x] = right.here;
        Rows::newer[x] = right.below;
      }
      if (y > 0 && x > 0) {
        out.write(stored_pair<Pair>(lowered(mid.here)));
        flags.write(maxima_flags(left, mid, right));
      }
    }
  }
}

}  // namespace hls
}  // namespace sailmap
