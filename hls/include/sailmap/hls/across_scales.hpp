// Across scales, spec section 6: the coarser sum, interpolated, plus the maps of this level.
//
// Streams: Count maps as lanes. In: `coarse`, level `Level` + 1 (its sum so far), and `fine`, level `Level`;
// out: level `Level`, all in raster order. Formats: level 4 and 3 maps to the partial sum, the partial sum
// and level 2 maps to the feature; the three kinds alike. Latency: row y of the output needs row ceil(y/2) of
// `coarse`, and the next coarse column; coarse row 0 is read before anything else. II 1 a fine pixel. `Kind`
// tells the instances apart. Maximum error of the features: accuracy::intensity_feature_bound,
// colour_feature_bound and orientation_feature_bound; a sum adds half a unit of its output.
#pragma once

#include "sailmap/hls/arithmetic.hpp"
#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/kinds.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

// The last coarse row read.
template <class Config, int Level, int Count, int Kind>
struct CoarseRow {
  static lanes_t<Count> words[Config::level_width(Level + 1)];
};
template <class Config, int Level, int Count, int Kind>
SAILMAP_MEMORY lanes_t<Count> CoarseRow<Config, Level, Count, Kind>::words[Config::level_width(Level + 1)];

// Lane by lane: a + b.
inline void sum_lanes(const Lanes<1, uint32_t>& a, const Lanes<1, uint32_t>& b, Lanes<1, uint32_t>& out) {
  out.first = a.first + b.first;
}
template <int Count>
inline void sum_lanes(const Lanes<Count, uint32_t>& a, const Lanes<Count, uint32_t>& b,
                      Lanes<Count, uint32_t>& out) {
  out.first = a.first + b.first;
  sum_lanes(a.rest, b.rest, out.rest);
}

// `four`: the sum of the four coarse neighbours.
template <int Level>
inline uint16_t scale_sum(uint32_t four, uint32_t fine) {
  return Level + 1 == geometry::top_level ? partial_sum(four, fine) : feature_sum(four, fine);
}
template <int Level>
inline void scale_sums(const Lanes<1, uint32_t>& four, const Lanes<1, uint32_t>& fine,
                       Lanes<1, uint32_t>& out) {
  out.first = scale_sum<Level>(four.first, fine.first);
}
template <int Level, int Count>
inline void scale_sums(const Lanes<Count, uint32_t>& four, const Lanes<Count, uint32_t>& fine,
                       Lanes<Count, uint32_t>& out) {
  out.first = scale_sum<Level>(four.first, fine.first);
  scale_sums<Level>(four.rest, fine.rest, out.rest);
}

// One output pixel: two coarse columns, each the sum of its upper and lower row, and the fine pixel.
template <int Level, int Count>
inline lanes_t<Count> scale_pixel(const Lanes<Count, uint32_t>& left, const Lanes<Count, uint32_t>& right,
                                  lanes_t<Count> fine_word) {
  Lanes<Count, uint32_t> four = Lanes<Count, uint32_t>();
  Lanes<Count, uint32_t> fine = four;
  Lanes<Count, uint32_t> out = four;
  sum_lanes(left, right, four);
  unpack(fine_word, fine);
  scale_sums<Level>(four, fine, out);
  return packed<lanes_t<Count> >(out);
}

template <class Config, int Level, int Count, int Kind>
void across_scales(stream<lanes_t<Count> >& coarse, stream<lanes_t<Count> >& fine,
                   stream<lanes_t<Count> >& out, uint16_t width, uint16_t height) {
  static_assert(geometry::map_levels == 3, "one partial sum, then the feature");
  lanes_t<Count>* const memory = CoarseRow<Config, Level, Count, Kind>::words;
  const int w = Config::columns(width, Level);
  const int h = Config::rows(height, Level);
  const int coarse_w = geometry::half(w);
#pragma nounroll
  for (int x = 0; x < coarse_w; ++x) {
    SAILMAP_PIPELINE
    memory[x] = coarse.read();
  }
#pragma nounroll
  for (int y = 0; y < h; ++y) {
    // Even rows lie on a coarse row; odd ones between the last and a new one, but for a last row without.
    const bool reads = (y & 1) != 0 && y + 1 < h;
    Lanes<Count, uint32_t> left = Lanes<Count, uint32_t>();
    Lanes<Count, uint32_t> right = left;
#pragma nounroll
    for (int x = 0; x <= coarse_w; ++x) {
      SAILMAP_PIPELINE_II(2)
      if (x < coarse_w) {
        const lanes_t<Count> upper_word = memory[x];
        lanes_t<Count> lower_word = upper_word;
        if (reads) lower_word = coarse.read();
        memory[x] = lower_word;
        Lanes<Count, uint32_t> upper = Lanes<Count, uint32_t>();
        Lanes<Count, uint32_t> lower = upper;
        unpack(upper_word, upper);
        unpack(lower_word, lower);
        sum_lanes(upper, lower, right);
      }
      if (x > 0) {
        out.write(scale_pixel<Level, Count>(left, left, fine.read()));
        if (2 * x - 1 < w) out.write(scale_pixel<Level, Count>(left, right, fine.read()));
      }
      left = right;
    }
  }
}

}  // namespace hls
}  // namespace sailmap
