// The salient regions of section 8: repeated arg-max over the saliency map, kept here, with inhibition of
// return (the box). Parts of the stage signature (signature.hpp).
//
// The map is kept four pixels a word and each row's maximum beside it with the place where it comes first. So
// a region costs one look at every row's maximum and one pass over the rows of its own box, which are
// suppressed and searched again at once: h + side ceil(w/4) cycles at II 1, not w h. Exact; ties are those of
// the spec, first in raster order.
#pragma once

#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/signature_arithmetic.hpp"
#include "sailmap/hls/signature_record.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

constexpr int saliency_lanes = 4;

// Words of a row of w pixels.
constexpr int saliency_words(int w) { return (w + saliency_lanes - 1) / saliency_lanes; }

template <class Config>
struct KeptSaliency {
  static constexpr int rows = Config::level_height(geometry::base_level);
  static constexpr int size = saliency_words(Config::level_width(geometry::base_level)) * rows;
  static uint64_t words[size];    // the left pixel low; 0 behind the last of a row
  static uint32_t highest[rows];  // the peak of each row
};
template <class Config>
SAILMAP_MEMORY uint64_t KeptSaliency<Config>::words[size];
template <class Config>
SAILMAP_MEMORY uint32_t KeptSaliency<Config>::highest[rows];

// A pixel as a candidate for its row's arg-max: the larger of two is the higher, of equals the left one.
constexpr int candidate_bits = 16;
constexpr uint32_t candidate_place = 0xffff;
inline uint32_t candidate(uint16_t value, int x) {
  return static_cast<uint32_t>(value) << candidate_bits | (candidate_place - static_cast<uint32_t>(x));
}
inline uint32_t value_of(uint32_t candidate) { return candidate >> candidate_bits; }
inline int column_of(uint32_t candidate) {
  return static_cast<int>(candidate_place - (candidate & candidate_place));
}
inline uint32_t higher(uint32_t a, uint32_t b) { return a > b ? a : b; }

// The columns, or rows, of the box of a region whose peak is at `at`: [start, end), cut at the border of a
// map of `size`.
inline int box_start(int at, int side) { return at < side / 2 ? 0 : at - side / 2; }
inline int box_end(int at, int side, int size) {
  return at - side / 2 + side < size ? at - side / 2 + side : size;
}

// The parameters of the search, within their limits.
inline int regions_within(uint16_t max_regions) {
  return max_regions < 1                               ? 1
         : max_regions > signature_record::max_regions ? signature_record::max_regions
                                                       : max_regions;
}
inline int side_within(uint16_t box_side) {
  return box_side < signature_record::min_box_side   ? signature_record::min_box_side
         : box_side > signature_record::max_box_side ? signature_record::max_box_side
                                                     : box_side;
}
inline uint32_t ratio_within(uint32_t stop_ratio) {
  return stop_ratio > signature_record::max_stop_ratio ? signature_record::max_stop_ratio : stop_ratio;
}

// Lane `Lane` of word i of a row, 0 in columns [x0, x1).
template <int Lane>
inline uint16_t uninhibited(uint64_t word, int i, int x0, int x1) {
  const int x = saliency_lanes * i + Lane;
  return x >= x0 && x < x1 ? uint16_t{0} : lane<Lane>(word);
}
template <int Lane>
inline uint32_t candidate_in(uint64_t word, int i) {
  return candidate(lane<Lane>(word), saliency_lanes * i + Lane);
}

// Inhibition of return in one row, whose first word is `start`: its new peak.
template <class Config>
inline uint32_t inhibit_row(int start, int row_words, int x0, int x1) {
  using Kept = KeptSaliency<Config>;
  uint32_t peak = 0;
#pragma nounroll
  for (int i = 0; i < row_words; ++i) {
    SAILMAP_PIPELINE
    const uint64_t before = Kept::words[start + i];
    const uint64_t word = pack(uninhibited<0>(before, i, x0, x1), uninhibited<1>(before, i, x0, x1),
                               uninhibited<2>(before, i, x0, x1), uninhibited<3>(before, i, x0, x1));
    Kept::words[start + i] = word;
    peak = higher(peak, higher(higher(candidate_in<0>(word, i), candidate_in<1>(word, i)),
                               higher(candidate_in<2>(word, i), candidate_in<3>(word, i))));
  }
  return peak;
}

// What the search found.
template <class Config>
struct FoundRegions {
  static uint32_t places[signature_record::max_regions];  // x low, y high, base-level pixels
  static uint16_t values[signature_record::max_regions];  // S
};
template <class Config>
SAILMAP_MEMORY uint32_t FoundRegions<Config>::places[signature_record::max_regions];
template <class Config>
SAILMAP_MEMORY uint16_t FoundRegions<Config>::values[signature_record::max_regions];

// Finds the regions of the kept map, w x h pixels, and how many they are. Afterwards the map is 0 in all
// their boxes.
template <class Config>
inline int find_regions(int w, int h, int max_regions, uint32_t stop_ratio, int side) {
  using Kept = KeptSaliency<Config>;
  using Found = FoundRegions<Config>;
  const int row_words = saliency_words(w);
  uint32_t first = 0;
  int count = 0;
  bool go_on = true;
#pragma nounroll
  while (go_on) {
    uint32_t best = 0;
    int y = 0;
#pragma nounroll
    for (int row = 0; row < h; ++row) {
      SAILMAP_PIPELINE
      const uint32_t peak = Kept::highest[row];
      if (value_of(peak) > value_of(best)) {
        best = peak;
        y = row;
      }
    }
    const uint32_t value = value_of(best);
    if (ends_search(value, first, stop_ratio, count == 0)) {
      go_on = false;
    } else {
      const int x = column_of(best);
      if (count == 0) first = value;
      Found::places[count] = signature_record::pair_of(static_cast<uint32_t>(x), static_cast<uint32_t>(y));
      Found::values[count] = static_cast<uint16_t>(value);
      ++count;
      go_on = count < max_regions;
      const int x0 = box_start(x, side);
      const int x1 = box_end(x, side, w);
      const int y1 = box_end(y, side, h);
#pragma nounroll
      for (int row = box_start(y, side); row < y1; ++row) {
        Kept::highest[row] = inhibit_row<Config>(row * row_words, row_words, x0, x1);
      }
    }
  }
  return count;
}

}  // namespace hls
}  // namespace sailmap
