// Across scales, spec section 6: the coarser sum, interpolated, plus the maps of this level.
//
// Streams: a pair of maps a word. In: `coarse`, level `Level` + 1 (its sum so far), and `fine`, level
// `Level`; out: level `Level`, all in raster order. Formats: level 4 and 3 maps to the partial sum, the
// partial sum and level 2 maps to the exact sum of all; the three kinds alike. Latency: row y of the output
// needs row ceil(y/2) of `coarse`, and the next coarse column; coarse row 0 is read before anything else. II
// 1 a fine pixel. `Pair` tells the instances apart. Maximum error of the features made of the sums:
// accuracy::intensity_feature_bound, colour_feature_bound and orientation_feature_bound.
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
template <class Config, int Level, int Pair>
struct CoarseRow {
  static uint64_t words[Config::level_width(Level + 1)];
};
template <class Config, int Level, int Pair>
SAILMAP_MEMORY uint64_t CoarseRow<Config, Level, Pair>::words[Config::level_width(Level + 1)];

// The upper and the lower row of one coarse column, summed, of both maps.
struct CoarseColumn {
  uint32_t first, second;
};
inline CoarseColumn coarse_column(uint64_t upper, uint64_t lower) {
  CoarseColumn out = {0, 0};
  out.first = wide_lane<0>(upper) + wide_lane<0>(lower);
  out.second = wide_lane<1>(upper) + wide_lane<1>(lower);
  return out;
}

// A pair of one level's contrasts or energies, or of partial sums.
inline uint64_t scale_words(uint64_t pair) {
  static_assert(formats::intensity_contrast::word == 18 && formats::colour_contrast::word == 18 &&
                    formats::gabor_energy::word == 18 && formats::intensity_partial::word == 18 &&
                    formats::colour_partial::word == 18 && formats::orientation_partial::word == 18,
                "18 bits hold what comes in");
  return narrow_pair<18>(pair);
}

// `four`: the sum of the four coarse neighbours.
template <int Level>
inline uint32_t scale_sum(uint32_t four, uint32_t fine) {
  return Level + 1 == geometry::top_level ? partial_sum(four, fine) : level_sum(four, fine);
}

// One output pixel: two coarse columns and the fine pixel.
template <int Level>
inline uint64_t scale_pixel(const CoarseColumn& left, const CoarseColumn& right, uint64_t fine) {
  return wide_pair(scale_sum<Level>(left.first + right.first, wide_lane<0>(fine)),
                   scale_sum<Level>(left.second + right.second, wide_lane<1>(fine)));
}

template <class Config, int Level, int Pair>
void across_scales(stream<uint64_t>& coarse, stream<uint64_t>& fine, stream<uint64_t>& out, uint16_t width,
                   uint16_t height) {
  static_assert(geometry::map_levels == 3, "one partial sum, then the sum of all");
  uint64_t* const memory = CoarseRow<Config, Level, Pair>::words;
  const int w = Config::columns(width, Level);
  const int h = Config::rows(height, Level);
  const int coarse_w = geometry::half(w);
#pragma nounroll
  for (int x = 0; x < coarse_w; ++x) {
    SAILMAP_PIPELINE
    memory[x] = scale_words(coarse.read());
  }
#pragma nounroll
  for (int y = 0; y < h; ++y) {
    // Even rows lie on a coarse row; odd ones between the last and a new one, but for a last row without.
    const bool reads = (y & 1) != 0 && y + 1 < h;
    // In front of every second pixel, the row's first and odd ones, comes a column that the last one may
    // lack: an even pixel lies on a column, between that one and itself.
    CoarseColumn left = {0, 0};
    CoarseColumn right = {0, 0};
#pragma nounroll
    for (int x = -1; x < w; ++x) {
      SAILMAP_PIPELINE
      const bool odd = (x & 1) != 0;
      const int next = (x + 1) >> 1;
      if (odd && next < coarse_w) {
        const uint64_t upper = scale_words(memory[next]);
        uint64_t lower = upper;
        if (reads) lower = scale_words(coarse.read());
        memory[next] = lower;
        right = coarse_column(upper, lower);
      }
      if (x >= 0) out.write(scale_pixel<Level>(left, right, scale_words(fine.read())));
      left = odd ? right : left;
    }
  }
}

}  // namespace hls
}  // namespace sailmap
