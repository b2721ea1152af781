// The signature of a frame, section 8, on the hardware: inhibition of return and descriptors, from what the
// front end puts out.
//
// Streams in: those of front_end.hpp, one frame a call. Out: `record`, the 248 words of signature_record.hpp.
// max_regions (1 to 20), stop_ratio (raw in formats::stop_ratio, 0 to 1) and box_side (2 to 16 base-level
// pixels) are the frame's parameters. Inhibition of return is the box, the descriptor eq. 3-4.
//
// Keeps the maps (208 bits a base-level pixel) and the saliency (16 bits) until the regions are found; reads
// what the front end puts out in the order that it comes in, so any depth of FIFOs will do. Latency from the
// last saliency to the last word, and II 1 of every loop: throughput::signature_search() and so on in
// signature_throughput.hpp. Formats: region sums exact, normalised_region_sum, descriptor_entry; one
// division, bit by bit, an entry. Regions and S are exact. Maximum error of an entry against eq. 3-4 in real
// numbers on the same maps: accuracy::descriptor_share of its value and accuracy::descriptor_bound.
#pragma once

#include "sailmap/hls/config.hpp"
#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/kinds.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/saliency.hpp"
#include "sailmap/hls/signature_arithmetic.hpp"
#include "sailmap/hls/signature_record.hpp"
#include "sailmap/hls/signature_search.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

// The maps as they came, and the gain of each feature map.
template <class Config>
struct KeptMaps {
  static constexpr int pixels = Config::level_pixels(geometry::base_level);
  static uint32_t intensity[pixels];
  static uint64_t colours[pixels];
  static uint64_t orientations[pixels];
  static uint32_t conspicuity_low[pixels];   // C_I, C_C
  static uint16_t conspicuity_high[pixels];  // C_O
  static uint32_t mantissas[geometry::feature_maps];
  static uint32_t shifts[geometry::feature_maps];
};
template <class Config>
SAILMAP_MEMORY uint32_t KeptMaps<Config>::intensity[pixels];
template <class Config>
SAILMAP_MEMORY uint64_t KeptMaps<Config>::colours[pixels];
template <class Config>
SAILMAP_MEMORY uint64_t KeptMaps<Config>::orientations[pixels];
template <class Config>
SAILMAP_MEMORY uint32_t KeptMaps<Config>::conspicuity_low[pixels];
template <class Config>
SAILMAP_MEMORY uint16_t KeptMaps<Config>::conspicuity_high[pixels];
template <class Config>
SAILMAP_MEMORY uint32_t KeptMaps<Config>::mantissas[geometry::feature_maps];
template <class Config>
SAILMAP_MEMORY uint32_t KeptMaps<Config>::shifts[geometry::feature_maps];

// Count sums, one scalar each.
template <int Count>
struct LaneSums {
  uint32_t sum;
  LaneSums<Count - 1> rest;

  void clear() {
    sum = 0;
    rest.clear();
  }
  template <class Word>
  void add(Word word) {
    sum += lane<0>(word);
    rest.add(static_cast<Word>(word >> lane_bits));
  }
  // The first of them; the others move up, `next` behind the last.
  uint32_t shift(uint32_t next) {
    const uint32_t first = sum;
    sum = rest.shift(next);
    return first;
  }
};
template <>
struct LaneSums<0> {
  void clear() {}
  template <class Word>
  void add(Word /*word*/) {}
  uint32_t shift(uint32_t next) { return next; }
};

// The sums over one region of all maps, registers.
struct RegionSums {
  LaneSums<2> intensity;
  LaneSums<4> colours;
  LaneSums<4> orientations;
  LaneSums<2> conspicuity_low;
  LaneSums<1> conspicuity_high;

  void clear() {
    intensity.clear();
    colours.clear();
    orientations.clear();
    conspicuity_low.clear();
    conspicuity_high.clear();
  }
  // Of the ten feature maps in their order, one a call.
  uint32_t next_feature() { return intensity.shift(colours.shift(orientations.shift(0))); }
  // The divisor of entry i.
  uint32_t divisor(int i) const {
    return i < geometry::intensity_maps
               ? entry_divisor<formats::intensity_conspicuity_region_sum>(conspicuity_low.sum)
           : i < geometry::intensity_maps + geometry::colour_maps
               ? entry_divisor<formats::colour_conspicuity_region_sum>(conspicuity_low.rest.sum)
               : entry_divisor<formats::orientation_conspicuity_region_sum>(conspicuity_high.sum);
  }
};

// The gains of the feature maps from their statistics; those of the conspicuities are not needed.
template <class Config>
inline void keep_gains(stream<uint32_t>& statistics, bool features) {
  using Kept = KeptMaps<Config>;
  const int words = 2 * (features ? geometry::feature_maps : geometry::conspicuity_maps);
  uint32_t maximum = 0;
#pragma nounroll
  for (int i = 0; i < words; ++i) {
    const uint32_t word = statistics.read();
    if ((i & 1) == 0) {
      maximum = word;
    } else if (features) {
      Kept::mantissas[i >> 1] = gain_mantissa(maximum, word);
      Kept::shifts[i >> 1] = static_cast<uint32_t>(gain_shift(maximum, word));
    }
  }
}

template <class Config>
inline void keep_features(stream<uint32_t>& intensity_maps, stream<uint64_t>& colour_maps,
                          stream<uint64_t>& orientation_maps, int pixels) {
  using Kept = KeptMaps<Config>;
#pragma nounroll
  for (int i = 0; i < pixels; ++i) {
    SAILMAP_PIPELINE
    Kept::intensity[i] = intensity_maps.read();
    Kept::colours[i] = colour_maps.read();
    Kept::orientations[i] = orientation_maps.read();
  }
}

// Conspicuities and saliency come side by side.
template <class Config>
inline void keep_saliency(stream<uint64_t>& conspicuity_maps, stream<uint16_t>& saliency, int w, int h) {
  using Kept = KeptMaps<Config>;
  using Searched = KeptSaliency<Config>;
  const int row_words = saliency_words(w);
  int at = 0;
#pragma nounroll
  for (int y = 0; y < h; ++y) {
    const int start = y * row_words;
    uint64_t word = 0;
    uint32_t peak = 0;
#pragma nounroll
    for (int x = 0; x < w; ++x) {
      SAILMAP_PIPELINE
      const uint64_t conspicuities = conspicuity_maps.read();
      const uint16_t value = saliency.read();
      Kept::conspicuity_low[at] = static_cast<uint32_t>(conspicuities);
      Kept::conspicuity_high[at] = lane<2>(conspicuities);
      ++at;
      // Complete with every fourth pixel, and put where it belongs with each.
      word = static_cast<uint64_t>(value) << 48 | word >> lane_bits;
      Searched::words[start + (x >> 2)] = word;
      peak = higher(peak, candidate(value, x));
    }
    // The last word of a row that is no multiple of four pixels long.
#pragma nounroll
    for (int x = w; x < saliency_lanes * row_words; ++x) {
      SAILMAP_PIPELINE
      word >>= lane_bits;
      Searched::words[start + (x >> 2)] = word;
    }
    Searched::highest[y] = peak;
  }
}

// The sums over the region at (x, y).
template <class Config>
inline void sum_region(int x, int y, int side, int w, int h, RegionSums& sums) {
  using Kept = KeptMaps<Config>;
  const int x0 = box_start(x, side);
  const int x1 = box_end(x, side, w);
  const int y1 = box_end(y, side, h);
  sums.clear();
#pragma nounroll
  for (int row = box_start(y, side); row < y1; ++row) {
    const int start = row * w;
#pragma nounroll
    for (int column = x0; column < x1; ++column) {
      SAILMAP_PIPELINE
      const int at = start + column;
      sums.intensity.add(Kept::intensity[at]);
      sums.colours.add(Kept::colours[at]);
      sums.orientations.add(Kept::orientations[at]);
      sums.conspicuity_low.add(Kept::conspicuity_low[at]);
      sums.conspicuity_high.add(Kept::conspicuity_high[at]);
    }
  }
}

// Ten words, of the region of these sums, which are used up.
template <class Config>
inline void write_entries(RegionSums& sums, stream<uint32_t>& record) {
  using Kept = KeptMaps<Config>;
#pragma nounroll
  for (int i = 0; i < geometry::feature_maps; ++i) {
    const Gain gain = {Kept::mantissas[i], static_cast<int>(Kept::shifts[i])};
    const uint64_t normalised = normalised_region_sum(sums.next_feature(), gain);
    record.write(descriptor_entry(normalised, sums.divisor(i)));
  }
}

template <class Config>
void signature(stream<uint32_t>& intensity_maps, stream<uint64_t>& colour_maps,
               stream<uint64_t>& orientation_maps, stream<uint64_t>& conspicuity_maps,
               stream<uint16_t>& saliency, stream<uint32_t>& statistics, stream<uint32_t>& record,
               uint16_t width, uint16_t height, uint16_t max_regions, uint32_t stop_ratio,
               uint16_t box_side) {
  using Found = FoundRegions<Config>;
  const int w = Config::columns(width, geometry::base_level);
  const int h = Config::rows(height, geometry::base_level);
  const int most = regions_within(max_regions);
  const int side = side_within(box_side);
  const uint32_t ratio = ratio_within(stop_ratio);

  // In the order in which the front end has them: a feature map's statistics, the feature maps, of which it
  // makes the conspicuities, their statistics, and they themselves. One loop for both, since Bambu keeps a
  // stream in a memory where a word that is read has no use.
#pragma nounroll
  for (int kind = 0; kind < 2; ++kind) {
    const bool features = kind == 0;
    keep_gains<Config>(statistics, features);
    if (features) {
      keep_features<Config>(intensity_maps, colour_maps, orientation_maps, w * h);
    } else {
      keep_saliency<Config>(conspicuity_maps, saliency, w, h);
    }
  }

  const int count = find_regions<Config>(w, h, most, ratio, side);
#pragma nounroll
  for (int i = 0; i < signature_record::header_words; ++i) {
    record.write(i == signature_record::mark_word          ? signature_record::mark_and_version
                 : i == signature_record::size_word        ? signature_record::pair_of(width, height)
                 : i == signature_record::count_word       ? static_cast<uint32_t>(count)
                 : i == signature_record::max_regions_word ? static_cast<uint32_t>(most)
                 : i == signature_record::stop_ratio_word  ? ratio
                 : i == signature_record::box_side_word    ? static_cast<uint32_t>(side)
                                                           : 0);
  }
#pragma nounroll
  for (int r = 0; r < count; ++r) {
    const uint32_t place = Found::places[r];
    const int x = signature_record::low_of(place);
    const int y = signature_record::high_of(place);
    RegionSums sums = RegionSums();
    sum_region<Config>(x, y, side, w, h, sums);
    record.write(place * geometry::base_scale);
    record.write(Found::values[r]);
    write_entries<Config>(sums, record);
  }
#pragma nounroll
  for (int i = count * signature_record::region_words;
       i < signature_record::max_regions * signature_record::region_words; ++i) {
    record.write(0);
  }
}

}  // namespace hls
}  // namespace sailmap
