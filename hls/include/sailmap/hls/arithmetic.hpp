// The declared steps of the kernels' arithmetic, each a pure function of integers: what is computed between
// two named points of formats.hpp. The kernels call these; the reference says the same in real numbers
// (ref/), and the tests hold the two together.
#pragma once

#include <cstdint>

#include "sailmap/hls/formats.hpp"
#include "sailmap/hls/gabor_coefficients.hpp"

namespace sailmap {
namespace hls {

// --- Section 2 ---

// s above a tenth of full scale: the pixel has colour.
constexpr bool has_colour(int s) { return 10 * s > 765; }

// colour_reciprocal of s = 0..765: 3/(2s) rounded to nearest, 0 without colour. An entry of the table.
constexpr word_t<formats::colour_reciprocal> colour_reciprocal(int s) {
  return has_colour(s) ? static_cast<word_t<formats::colour_reciprocal>>(
                             ((std::uint32_t{3} << formats::colour_reciprocal::fraction) /
                                  static_cast<std::uint32_t>(s) +
                              1) /
                             2)
                       : word_t<formats::colour_reciprocal>{0};
}

// k times `doubled` = 2r-g-b, 2g-r-b, 2b-r-g or 2 min(r,g) - 2b, negative values cut to 0: R, G, B, Y.
constexpr formats::colour::native tuned_colour(std::uint32_t reciprocal, int doubled) {
  return requantise<Exactly<25, formats::colour_reciprocal::fraction>, formats::colour>(
      reciprocal * static_cast<std::uint32_t>(doubled > 0 ? doubled : 0));
}

// --- Section 3: `sum` is the 5x5 binomial sum, weights adding up to 256 ---

// Level 0 to level 1 of intensity, from the 10-bit s.
constexpr formats::intensity::native reduce_grey(std::uint32_t sum) {
  return requantise<Exactly<18, formats::grey_sum::fraction + 8>, formats::intensity>(sum);
}
// Any other reduction: the formats of intensity and colour differ in the place of the point alone.
constexpr formats::intensity::native reduce(std::uint32_t sum) {
  return requantise<Exactly<24, formats::intensity::fraction + 8>, formats::intensity>(sum);
}
static_assert(formats::intensity::word == formats::colour::word, "one kernel serves both");

// --- Section 4: centre against its 7x7 and 15x15 box sums (centre included), all raw ---

// 672 times the sum over both radii of max(0, +-(centre - surround)): 672/48 = 14, 672/224 = 3.
// `sign` is 1 for on and -1 for off.
constexpr std::int32_t contrast_sum(std::int32_t centre, std::int32_t small_box, std::int32_t large_box,
                                    int sign) {
  return 14 * ((sign * (49 * centre - small_box) > 0) ? sign * (49 * centre - small_box) : 0) +
         3 * ((sign * (225 * centre - large_box) > 0) ? sign * (225 * centre - large_box) : 0);
}
// Of intensity and colour alike, rounded.
constexpr formats::intensity_contrast::native contrast(std::int32_t centre, std::int32_t small_box,
                                                       std::int32_t large_box, int sign) {
  // 672 = 32 * 21: five fraction bits, and the 21 in the unit.
  return requantise<Exactly<27, formats::intensity::fraction + 5>, formats::intensity_contrast>(
      static_cast<std::uint32_t>(contrast_sum(centre, small_box, large_box, sign)));
}
static_assert(formats::intensity::fraction - formats::intensity_contrast::fraction ==
                  formats::colour::fraction - formats::colour_contrast::fraction,
              "one kernel serves both");

// --- Section 5 ---

// A vertical 1-D sum of raw intensities with the taps of E, O, C, S or G.
constexpr formats::gabor_column::native gabor_column(std::int32_t sum) {
  return requantise<Exactly<31, formats::intensity::fraction, Sign::is_signed>, formats::gabor_column>(sum);
}
// Magnitude of a 2-D sum of raw columns.
constexpr std::uint32_t gabor_response(std::int32_t sum) {
  return requantise<Exactly<29, formats::gabor_column::fraction>, formats::gabor_response>(
      static_cast<std::uint32_t>(sum < 0 ? -sum : sum));
}
// gabor_scale of an integer window's sum of absolute values: 1/scale, rounded to nearest.
constexpr std::uint32_t gabor_scale(std::int64_t scale) {
  return static_cast<std::uint32_t>(((std::int64_t{1} << (formats::gabor_scale::fraction + 1)) / scale + 1) /
                                    2);
}
// |even| + |odd| of two responses, in `orientation` = theta / 45 degrees.
constexpr formats::gabor_energy::native gabor_energy(int orientation, std::uint32_t even, std::uint32_t odd) {
  return requantise<Exactly<35, formats::gabor_response::fraction + formats::gabor_scale::fraction>,
                    formats::gabor_energy>(
      static_cast<std::uint64_t>(even) * gabor_scale(gabor::even_scale(orientation)) +
      static_cast<std::uint64_t>(odd) * gabor_scale(gabor::odd_scale(orientation)));
}

// --- Section 6: `coarse` is the sum of the four neighbours of the coarser level (interpolation times 4) ---

// Levels 4 and 3 to the partial sum; of intensity, colour and orientation alike.
constexpr formats::intensity_partial::native partial_sum(std::uint32_t coarse, std::uint32_t finer) {
  return requantise<Exactly<21, formats::intensity_contrast::fraction + 2>, formats::intensity_partial>(
      coarse + 4 * finer);
}
// The partial sum and level 2 to the sum of all levels, which is exact.
constexpr formats::intensity_sum::native level_sum(std::uint32_t coarse, std::uint32_t finer) {
  return coarse + 2 * finer;
}
// That sum to the feature map.
constexpr formats::intensity_feature::native feature(std::uint32_t sum) {
  return requantise<formats::intensity_sum, formats::intensity_feature>(sum);
}

template <class Level, class Partial, class Sum, class Feature>
struct alike {
  static constexpr bool value = Level::fraction == Partial::fraction + 1 &&
                                Sum::fraction == Partial::fraction + 2 &&
                                Sum::fraction == Feature::fraction + 5;
};
static_assert(alike<formats::intensity_contrast, formats::intensity_partial, formats::intensity_sum,
                    formats::intensity_feature>::value &&
                  alike<formats::colour_contrast, formats::colour_partial, formats::colour_sum,
                        formats::colour_feature>::value &&
                  alike<formats::gabor_energy, formats::orientation_partial, formats::orientation_sum,
                        formats::orientation_feature>::value,
              "one kernel serves all three kinds");

// --- Section 7 ---

// floor(sqrt(value)), value below 2^62: two bits of the value and one of the root a turn, so that what is
// compared is no wider than the root.
constexpr std::uint32_t isqrt(std::uint64_t value) {
  std::uint64_t rest = 0;
  std::uint32_t root = 0;
#pragma nounroll
  for (int i = 0; i < 31; ++i) {
    rest = ((rest << 2) | (value >> 60 & 3U)) & ((std::uint64_t{1} << 34) - 1);
    value <<= 2;
    const std::uint64_t odd = (std::uint64_t{root} << 2) | 1U;
    root <<= 1;
    if (rest >= odd) {
      rest -= odd;
      root |= 1U;
    }
  }
  return root;
}

// floor(2^48 / divisor) for a divisor in [2^32, 2^34], at most 2^16 - 1: bit by bit, a bit of quotient a
// turn. The masks lose nothing: they tell a tool how wide its registers need be.
constexpr std::uint32_t reciprocal(std::uint64_t divisor) {
  constexpr std::uint64_t bits = (std::uint64_t{1} << 36) - 1;
  const std::uint64_t by = divisor & bits;
  std::uint32_t quotient = 0;
  std::uint64_t rest = std::uint64_t{1} << 31;
#pragma nounroll
  for (int i = 0; i < 17; ++i) {
    rest = (rest << 1) & bits;
    quotient <<= 1;
    if (rest >= by) {
      rest -= by;
      quotient |= 1U;
    }
  }
  return quotient > 0xffffU ? 0xffffU : quotient;
}

// 1 / (max sqrt(m)) of a map: normalised raw = (map raw * mantissa * 16) >> shift. 0 for a flat zero map.
struct Gain {
  std::uint32_t mantissa;  // formats::gain
  int shift;               // 0 to 24
};

// `maximum`: raw, 1 to 65535; `maxima`: 1 to 2^18 (local maxima are never adjacent). Both are 0 for a flat
// zero map. Shifts go a step a turn: there is time for it once a frame, and a shift by any number of bits
// would be as much logic as all the rest.

// The maximum in [2^15, 2^16).
constexpr std::uint32_t scaled_maximum(std::uint32_t maximum) {
  std::uint32_t scaled = maximum & 0xffffU;
#pragma nounroll
  for (int i = 0; i < 15; ++i) scaled = (scaled >> 15) == 0 ? scaled << 1 : scaled;
  return scaled;
}
// The root of the maxima as in formats::square_root, [2^17, 2^18): they are taken times a power of 4, in
// [2^34, 2^36).
constexpr std::uint32_t scaled_root(std::uint32_t maxima) {
  std::uint64_t scaled = std::uint64_t{maxima} << 16;
#pragma nounroll
  for (int i = 0; i < 9; ++i) scaled = (scaled >> 34) == 0 ? scaled << 2 : scaled;
  return isqrt(scaled);
}

// In two functions that return numbers: a structure that Bambu does not inline is in a memory.
constexpr std::uint32_t gain_mantissa(std::uint32_t maximum, std::uint32_t maxima) {
  return maximum == 0 ? 0 : reciprocal(std::uint64_t{scaled_maximum(maximum)} * scaled_root(maxima));
}
// The places of the leading ones of the maximum and of the root.
constexpr int gain_shift(std::uint32_t maximum, std::uint32_t maxima) {
  int shift = 0;
#pragma nounroll
  for (int i = 0; i < 15; ++i) {
    maximum >>= 1;
    maxima >>= i < 9 ? 2 : 0;
    shift += (maximum != 0 ? 1 : 0) + (i < 9 && maxima != 0 ? 1 : 0);
  }
  return shift;
}
constexpr Gain gain(std::uint32_t maximum, std::uint32_t maxima) {
  return Gain{gain_mantissa(maximum, maxima), gain_shift(maximum, maxima)};
}

// X~ or C~ of one pixel, value <= maximum. Both normalised formats are the same, below 1.
constexpr formats::normalised::native normalise(std::uint32_t value, const Gain& g) {
  constexpr int finer = formats::normalised::fraction - formats::gain::fraction;
  return static_cast<formats::normalised::native>((static_cast<std::uint64_t>(value * g.mantissa) << finer) >>
                                                  g.shift);
}
// Two entries of the table that happen to be equal. NOLINTNEXTLINE(misc-redundant-expression)
static_assert(formats::normalised::fraction == formats::normalised_conspicuity::fraction,
              "one kernel serves both");

// C from the exact sum of the normalised maps of its kind: two of intensity, four of colour or orientation.
constexpr formats::intensity_conspicuity::native intensity_conspicuity(std::uint32_t sum) {
  return requantise<formats::intensity_conspicuity_sum, formats::intensity_conspicuity>(sum);
}
constexpr formats::colour_conspicuity::native colour_conspicuity(std::uint32_t sum) {
  return requantise<formats::colour_conspicuity_sum, formats::colour_conspicuity>(sum);
}
constexpr formats::orientation_conspicuity::native orientation_conspicuity(std::uint32_t sum) {
  return requantise<formats::orientation_conspicuity_sum, formats::orientation_conspicuity>(sum);
}

// S from the sum of the three normalised C.
constexpr formats::saliency::native saliency(std::uint32_t sum) {
  return requantise<Exactly<22, formats::normalised_conspicuity::fraction>, formats::saliency>(sum);
}

}  // namespace hls
}  // namespace sailmap
