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

// Three rows of one column, a pair each, and which of them lie inside the image.
struct MaximaColumn {
  uint64_t above, here, below;
  bool has_above, has_here, has_below;
};

// Lane `Lane` of the pair at the centre of three columns.
template <int Lane>
inline bool is_local_maximum(const MaximaColumn& left, const MaximaColumn& mid, const MaximaColumn& right) {
  const uint32_t v = wide_lane<Lane>(mid.here);
  return (!left.has_above || v > wide_lane<Lane>(left.above)) &&
         (!mid.has_above || v > wide_lane<Lane>(mid.above)) &&
         (!right.has_above || v > wide_lane<Lane>(right.above)) &&
         (!left.has_here || v > wide_lane<Lane>(left.here)) &&
         (!right.has_here || v >= wide_lane<Lane>(right.here)) &&
         (!left.has_below || v >= wide_lane<Lane>(left.below)) &&
         (!mid.has_below || v >= wide_lane<Lane>(mid.below)) &&
         (!right.has_below || v >= wide_lane<Lane>(right.below));
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
    MaximaColumn left = {0, 0, 0, false, false, false};
    MaximaColumn mid = left;
    MaximaColumn right = left;
#pragma nounroll
    for (int x = 0; x <= w; ++x) {
      SAILMAP_PIPELINE
      left = mid;
      mid = right;
      right.has_above = x < w && y > 1;
      right.has_here = x < w;
      right.has_below = x < w && y < h;
      if (x < w) {
        right.above = Rows::older[x];
        right.here = Rows::newer[x];
        if (y < h) right.below = in.read();
        Rows::older[x] = right.here;
        Rows::newer[x] = right.below;
      }
      if (y > 0 && x > 0) {
        out.write(stored_pair<Pair>(mid.here));
        flags.write(maxima_flags(left, mid, right));
      }
    }
  }
}

}  // namespace hls
}  // namespace sailmap
