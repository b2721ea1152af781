// Normalisation, spec section 7 (eq. 1), and the sum over the maps of a kind: conspicuity; over the kinds:
// saliency.
//
// Stage `gains`: for each of Count lanes, maximum and m in; the same, and the gain 1/(maximum sqrt(m)) as
// mantissa and shift, out. Once a frame, some 100 cycles. Stage `normalise`: gains, then the maps as lanes
// in; the maps unchanged, and the sum of the normalised lanes out. Base level, raster order. Formats:
// normalised and its exact sum (intensity_conspicuity_sum and so on), or normalised_conspicuity and saliency;
// one multiplication a pixel and lane.
// Latency 0. II 1. `Kind` tells the instances apart: their loops count from it, since Bambu makes one of two
// functions with the same body and then misses the other. Maximum errors against the exact maps:
// accuracy::conspicuity_share and accuracy::saliency_share of the largest value.
#pragma once

#include "sailmap/hls/arithmetic.hpp"
#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/kinds.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

template <class Config, int Count, int Kind>
void gains(stream<uint32_t>& statistics, stream<uint32_t>& statistics_out, stream<uint32_t>& gains_out) {
  uint32_t before = 0;
  // A word a turn: Bambu keeps the order of reads from turn to turn alone.
#pragma nounroll
  for (int i = 2 * Kind; i < 2 * (Count + Kind); ++i) {
    const uint32_t word = statistics.read();
    statistics_out.write(word);
    if ((i & 1) != 0) {
      gains_out.write(gain_mantissa(before, word));
      gains_out.write(static_cast<uint32_t>(gain_shift(before, word)));
    }
    before = word;
  }
}

// The sum of normalised maps as it leaves the stage: a conspicuity exact, saliency in its 16 bits.
template <int Kind>
struct NormalisedSum {
  using word = uint32_t;
  static word of(uint32_t sum) { return sum; }
};
template <>
struct NormalisedSum<conspicuity_kind> {
  using word = uint16_t;
  static word of(uint32_t sum) { return saliency(sum); }
};

// The gains of lanes 0 to Count - 1.
template <int Count>
struct LaneGains {
  uint32_t mantissa, shift;  // of lane Count - 1
  LaneGains<Count - 1> rest;

  void clear() {
    mantissa = 0;
    shift = 0;
    rest.clear();
  }
  // A shift register, in which mantissa and shift of lane 0 are the first of 2 * Count words.
  void push(uint32_t word) {
    rest.push(mantissa);
    mantissa = shift;
    shift = word;
  }
  // Sum of the normalised lanes.
  template <class Word>
  uint32_t sum(Word word) const {
    return normalise(lane<Count - 1>(word), Gain{mantissa, static_cast<int>(shift)}) + rest.sum(word);
  }
};
template <>
struct LaneGains<0> {
  void clear() {}
  void push(uint32_t /*word*/) {}
  template <class Word>
  uint32_t sum(Word /*word*/) const {
    return 0;
  }
};

template <class Config, int Count, int Kind>
void normalise(stream<uint32_t>& gains_in, stream<lanes_t<Count> >& maps, stream<lanes_t<Count> >& maps_out,
               stream<typename NormalisedSum<Kind>::word>& sum_out, uint16_t width, uint16_t height) {
  const int pixels =
      Config::columns(width, geometry::base_level) * Config::rows(height, geometry::base_level);
  LaneGains<Count> lanes = LaneGains<Count>();
  lanes.clear();
#pragma nounroll
  for (int i = 2 * Kind; i < 2 * (Count + Kind); ++i) lanes.push(gains_in.read());
#pragma nounroll
  for (int i = Kind; i < pixels + Kind; ++i) {
    SAILMAP_PIPELINE
    const lanes_t<Count> word = maps.read();
    const uint32_t sum = lanes.sum(word);
    maps_out.write(word);
    sum_out.write(NormalisedSum<Kind>::of(sum));
  }
}

}  // namespace hls
}  // namespace sailmap
