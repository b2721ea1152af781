// Normalisation, spec section 7 (eq. 1), and the sum over the maps of a kind: conspicuity; over the kinds:
// saliency.
//
// Stages `gains_of_features` and `gains_of_conspicuity`: for each map, maximum and m in; the same, and the
// gain 1/(maximum sqrt(m)) as mantissa and shift, out. Once a frame, some 100 cycles a map. Stage
// `normalise`: gains, then the maps as Count lanes in, feature maps twice; the sum of the normalised lanes
// out. Base level, raster order. Formats: normalised and its exact sum (intensity_conspicuity_sum and so on),
// or normalised_conspicuity and saliency; one multiplication a pixel and lane. Latency 0. II 1. `Kind` tells
// the instances apart: their loops count from it, since Bambu makes one of two functions with the same body
// and then misses the other. Maximum errors against the exact maps: accuracy::conspicuity_share and
// accuracy::saliency_share of the largest value.
#pragma once

#include "sailmap/hls/arithmetic.hpp"
#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/kinds.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

// Maximum and m of the ten feature maps, a map after the other; then mantissa and shift in their places.
constexpr int feature_words = 2 * geometry::feature_maps;
template <class Config>
struct GainMemory {
  static uint32_t words[feature_words];
};
template <class Config>
SAILMAP_MEMORY uint32_t GainMemory<Config>::words[feature_words];

template <int First, int Last>
inline void statistics_in(stream<uint32_t>& in, stream<uint32_t>& out, uint32_t* words) {
#pragma nounroll
  for (int i = First; i < Last; ++i) {
    const uint32_t word = in.read();
    words[i] = word;
    out.write(word);
  }
}
template <int First, int Last>
inline void gains_out_of(const uint32_t* words, stream<uint32_t>& out) {
#pragma nounroll
  for (int i = First; i < Last; ++i) out.write(words[i]);
}

// All feature maps in one stage, a map after the other: there is time for it, and a gain is more logic than
// the rest of the stage. Each stream has loops of its own, and the words meet in a memory: of reads under
// conditions Bambu's compiler makes one read of one of the streams, and the Verilog is of that one alone.
template <class Config>
void gains_of_features(stream<uint32_t>& intensity, stream<uint32_t>& colour, stream<uint32_t>& orientation,
                       stream<uint32_t>& statistics_out, stream<uint32_t>& intensity_gains,
                       stream<uint32_t>& colour_gains, stream<uint32_t>& orientation_gains) {
  constexpr int end_of_intensity = 2 * geometry::intensity_maps;
  constexpr int end_of_colour = end_of_intensity + 2 * geometry::colour_maps;
  uint32_t* const words = GainMemory<Config>::words;
  statistics_in<0, end_of_intensity>(intensity, statistics_out, words);
  statistics_in<end_of_intensity, end_of_colour>(colour, statistics_out, words);
  statistics_in<end_of_colour, feature_words>(orientation, statistics_out, words);
#pragma nounroll
  for (int i = 0; i < feature_words; i += 2) {
    const uint32_t maximum = words[i];
    const uint32_t maxima = words[i + 1];
    words[i] = gain_mantissa(maximum, maxima);
    words[i + 1] = static_cast<uint32_t>(gain_shift(maximum, maxima));
  }
  gains_out_of<0, end_of_intensity>(words, intensity_gains);
  gains_out_of<end_of_intensity, end_of_colour>(words, colour_gains);
  gains_out_of<end_of_colour, feature_words>(words, orientation_gains);
}

// Maximum and m of each map, as the front end puts them out: the ten feature maps in the order of section 6,
// then C_I, C_C and C_O.
constexpr int statistics_words = feature_words + 2 * geometry::conspicuity_maps;

// C_I, C_C and C_O. A stage of its own, since these come of the features' gains: dataflow has no way back.
// `features` are put out in front, unchanged.
template <class Config>
void gains_of_conspicuity(stream<uint32_t>& features, stream<uint32_t>& conspicuity,
                          stream<uint32_t>& statistics, stream<uint32_t>& gains_out) {
#pragma nounroll
  for (int i = 0; i < feature_words; ++i) statistics.write(features.read());
  uint32_t before = 0;
#pragma nounroll
  for (int i = feature_words; i < statistics_words; ++i) {
    const uint32_t word = conspicuity.read();
    statistics.write(word);
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
void normalise(stream<uint32_t>& gains_in, stream<lanes_t<Count> >& maps,
               stream<typename NormalisedSum<Kind>::word>& sum_out, uint16_t width, uint16_t height) {
  const int pixels = (Kind == conspicuity_kind ? 1 : passes) * Config::columns(width, geometry::base_level) *
                     Config::rows(height, geometry::base_level);
  LaneGains<Count> lanes = LaneGains<Count>();
  lanes.clear();
#pragma nounroll
  for (int i = 2 * Kind; i < 2 * (Count + Kind); ++i) lanes.push(gains_in.read());
#pragma nounroll
  for (int i = Kind; i < pixels + Kind; ++i) {
    SAILMAP_PIPELINE
    const lanes_t<Count> word = maps.read();
    sum_out.write(NormalisedSum<Kind>::of(lanes.sum(word)));
  }
}

}  // namespace hls
}  // namespace sailmap
