// Local maxima of section 7: a pixel > the four neighbours already scanned (three above, one left) and >= the
// other four; outside the image counts as -infinity.
//
// Streams, base level, Count maps as lanes, raster order. In: the maps. Out: the maps, and a word of flags a
// pixel, bit l for lane l. Latency: 1 row and 1 column. II 1. Exact. `Kind` tells the instances apart.
#pragma once

#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/kinds.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

// The last two rows; `newer` is the one above the newest.
template <class Config, int Count, int Kind>
struct MaximaRows {
  static lanes_t<Count> newer[Config::level_width(geometry::base_level)];
  static lanes_t<Count> older[Config::level_width(geometry::base_level)];
};
template <class Config, int Count, int Kind>
SAILMAP_MEMORY lanes_t<Count> MaximaRows<Config, Count, Kind>::newer[Config::level_width(geometry::base_level)];
template <class Config, int Count, int Kind>
SAILMAP_MEMORY lanes_t<Count> MaximaRows<Config, Count, Kind>::older[Config::level_width(geometry::base_level)];

// Three rows of one column, packed, and which of them lie inside the image.
template <class Word>
struct MaximaColumn {
  Word above, here, below;
  bool has_above, has_here, has_below;
};

// Lane 0 of the word at the centre of three columns.
template <class Word>
inline bool is_local_maximum(const MaximaColumn<Word>& left, const MaximaColumn<Word>& mid,
                             const MaximaColumn<Word>& right) {
  const uint16_t v = lane<0>(mid.here);
  return (!left.has_above || v > lane<0>(left.above)) && (!mid.has_above || v > lane<0>(mid.above)) &&
         (!right.has_above || v > lane<0>(right.above)) && (!left.has_here || v > lane<0>(left.here)) &&
         (!right.has_here || v >= lane<0>(right.here)) && (!left.has_below || v >= lane<0>(left.below)) &&
         (!mid.has_below || v >= lane<0>(mid.below)) && (!right.has_below || v >= lane<0>(right.below));
}

template <class Word>
inline MaximaColumn<Word> next_lane(MaximaColumn<Word> column) {
  column.above = static_cast<Word>(column.above >> lane_bits);
  column.here = static_cast<Word>(column.here >> lane_bits);
  column.below = static_cast<Word>(column.below >> lane_bits);
  return column;
}

// Flags of Count lanes.
template <int Count>
struct MaximaFlags {
  template <class Word>
  static uint8_t of(const MaximaColumn<Word>& left, const MaximaColumn<Word>& mid,
                    const MaximaColumn<Word>& right) {
    const uint8_t rest = MaximaFlags<Count - 1>::of(next_lane(left), next_lane(mid), next_lane(right));
    return static_cast<uint8_t>(static_cast<uint8_t>(rest << 1) |
                                (is_local_maximum(left, mid, right) ? 1 : 0));
  }
};
template <>
struct MaximaFlags<0> {
  template <class Word>
  static uint8_t of(const MaximaColumn<Word>& /*left*/, const MaximaColumn<Word>& /*mid*/,
                    const MaximaColumn<Word>& /*right*/) {
    return 0;
  }
};

template <class Config, int Count, int Kind>
void local_maxima(stream<lanes_t<Count> >& in, stream<lanes_t<Count> >& out, stream<uint8_t>& flags,
                  uint16_t width, uint16_t height) {
  using Word = lanes_t<Count>;
  using Rows = MaximaRows<Config, Count, Kind>;
  const int w = geometry::base_side(width);
  const int h = geometry::base_side(height);
#pragma nounroll
  for (int y = 0; y <= h; ++y) {
    MaximaColumn<Word> left = {0, 0, 0, false, false, false};
    MaximaColumn<Word> mid = left;
    MaximaColumn<Word> right = left;
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
        out.write(mid.here);
        flags.write(MaximaFlags<Count>::of(left, mid, right));
      }
    }
  }
}

}  // namespace hls
}  // namespace sailmap
