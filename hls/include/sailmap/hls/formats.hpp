// The number formats of the design: one table, every named point (spec section 9). docs/formats.md is made
// from it.
//
// The reference's quantised policy rounds at exactly these points; between two of them all arithmetic is
// exact, there in double, in the kernels in integers. A real number of the spec is raw * 2^-fraction * unit.
// Units that are no power of two save divisions: normalisation (eq. 1) divides a map by its own maximum, so
// that the unit cancels.
//   one       1
//   grey      1/765              intensity is kept as s = r+g+b
//   grey21    1/(765*21)         contrasts divide by 48 and 224, with 672 = 32*21 in common: the 21 stays in
//   the unit colour21  1/21 block     2^k, k chosen for the number (see arithmetic.hpp)
// Intensity and colour use the same raw numbers from the pyramid to the feature maps: one kernel serves both.
// Overflow is `wrap` throughout: ranges.hpp proves that no value leaves its format.
#pragma once

#include "sailmap/hls/requantise.hpp"

// X(name, word, fraction, sign, rounding, unit, what)
#define SAILMAP_FORMAT_TABLE(X)                                                                     \
  /* channels, spec 2 */                                                                            \
  X(grey_sum, 10, 0, unsigned, rnd, grey, "s = r+g+b, intensity of level 0")                        \
  X(colour_reciprocal, 16, 21, unsigned, rnd, one,                                                  \
    "3/(2s), table of 766 words, 0 for s up to a tenth of full scale")                              \
  X(colour, 16, 14, unsigned, rnd, one, "R, G, B, Y of levels 0 to 4")                              \
  /* pyramid, spec 3 */                                                                             \
  X(intensity, 16, 6, unsigned, rnd, grey, "I of levels 1 to 4")                                    \
  /* centre-surround, spec 4 */                                                                     \
  X(intensity_box_small, 22, 6, unsigned, rnd, grey, "sum of the 7x7 window of I, exact")           \
  X(intensity_box_large, 24, 6, unsigned, rnd, grey, "sum of the 15x15 window of I, exact")         \
  X(colour_box_small, 22, 14, unsigned, rnd, one, "sum of the 7x7 window of a colour, exact")       \
  X(colour_box_large, 24, 14, unsigned, rnd, one, "sum of the 15x15 window of a colour, exact")     \
  X(intensity_contrast, 16, 1, unsigned, rnd, grey21, "on or off of I at one level, both radii")    \
  X(colour_contrast, 16, 9, unsigned, rnd, colour21, "on of a colour at one level, both radii")     \
  /* orientation, spec 5 */                                                                         \
  X(gabor_column, 16, -5, signed, rnd, grey, "vertical 1-D sums of I: filters E, O, C, S, G")       \
  X(gabor_response, 18, -13, unsigned, rnd, grey, "magnitude of an even or odd 2-D sum")            \
  X(gabor_scale, 15, 34, unsigned, rnd, one, "1 / sum of absolute values of an integer 2-D window") \
  X(gabor_energy, 16, 6, unsigned, rnd, grey, "|even| + |odd| at one level")                        \
  /* across scales, spec 6 */                                                                       \
  X(intensity_partial, 16, 0, unsigned, rnd, grey21, "levels 4 and 3 summed, size of level 3")      \
  X(colour_partial, 16, 8, unsigned, rnd, colour21, "levels 4 and 3 summed, size of level 3")       \
  X(orientation_partial, 16, 5, unsigned, rnd, grey, "levels 4 and 3 summed, size of level 3")      \
  X(intensity_feature, 16, -1, unsigned, rnd, grey21, "feature maps intensity_on, intensity_off")   \
  X(colour_feature, 16, 7, unsigned, rnd, colour21, "feature maps green, blue, red, yellow")        \
  X(orientation_feature, 16, 4, unsigned, rnd, grey, "feature maps ori_0, ori_45, ori_90, ori_135") \
  /* normalisation, spec 7 */                                                                       \
  X(maxima_count, 19, 0, unsigned, rnd, one, "m, local maxima above half the maximum")              \
  X(square_root, 18, 17, unsigned, trn, block, "sqrt(m), scaled to [1, 2)")                         \
  X(gain, 16, 15, unsigned, trn, block, "1 / (max sqrt(m)), both scaled to [1, 2)")                 \
  X(normalised, 16, 15, unsigned, rnd, one, "a feature map divided by max sqrt(m)")                 \
  X(conspicuity, 16, 13, unsigned, rnd, one, "C_I, C_C, C_O before their own normalisation")        \
  X(normalised_conspicuity, 16, 15, unsigned, rnd, one, "a conspicuity map divided by max sqrt(m)") \
  X(saliency, 16, 14, unsigned, rnd, one, "S")

namespace sailmap {
namespace hls {

namespace unit {
constexpr double one = 1;
constexpr double grey = 1.0 / 765;
constexpr double grey21 = 1.0 / (765 * 21);
constexpr double colour21 = 1.0 / 21;
constexpr double block = 1;
}  // namespace unit

// Every point is a type of its own, so that its name can be given where it is used.
namespace formats {
#define SAILMAP_DECLARE_FORMAT(name, word, fraction, sign, rounding, unit_name, what)         \
  struct name : Format<word, fraction, Sign::is_##sign, Rounding::rounding, Overflow::wrap> { \
    static constexpr double unit() { return hls::unit::unit_name; }                           \
  };
SAILMAP_FORMAT_TABLE(SAILMAP_DECLARE_FORMAT)
#undef SAILMAP_DECLARE_FORMAT
}  // namespace formats

}  // namespace hls
}  // namespace sailmap
