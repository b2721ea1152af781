// The number formats of the design: one table, every named point (spec section 9); docs/formats.md is made
// from it.
//
// The reference's quantised policy rounds at exactly these points; between two of them all arithmetic is
// exact, there in double, in the kernels in integers. A real number of the spec is raw * 2^-fraction * unit.
// Intensity and colour use the same raw numbers from the pyramid to the feature maps: one kernel serves both.
//
// Overflow is `wrap`, which costs nothing: ranges.hpp proves that no value leaves its format. `sat` is meant:
// the gain of a lone peak whose height is a power of two would be 1, and 1 - 2^-16 keeps it in 16 bits and
// all that is multiplied by it below 1. Normalised and conspicuity values are truncated for the same reason:
// a sum of values below 1 stays below their number.
//
// Maps are stored and put out in 16 bits, but eq. 1 counts local maxima: neighbours that differ by less than
// the last of 16 bits are common on smooth maps, and each that becomes equal may change m and with it the
// scale of the whole map. So the maps are wider up to where local maxima are found (the `sum` points).
#pragma once

#include "sailmap/hls/requantise.hpp"

// X(name, word, fraction, sign, rounding, overflow, unit, what)
#define SAILMAP_FORMAT_TABLE(X)                                                                             \
  /* channels, spec 2 */                                                                                    \
  X(grey_sum, 10, 0, unsigned, rnd, wrap, grey, "s = r+g+b, intensity of level 0")                          \
  X(colour_reciprocal, 16, 21, unsigned, rnd, wrap, one,                                                    \
    "3/(2s), table of 766 words, 0 for s up to a tenth of full scale")                                      \
  X(colour, 16, 14, unsigned, rnd, wrap, one, "R, G, B, Y of levels 0 to 4")                                \
  /* pyramid, spec 3 */                                                                                     \
  X(intensity, 16, 6, unsigned, rnd, wrap, grey, "I of levels 1 to 4")                                      \
  /* centre-surround, spec 4 */                                                                             \
  X(intensity_box_small, 22, 6, unsigned, rnd, wrap, grey, "sum of the 7x7 window of I, exact")             \
  X(intensity_box_large, 24, 6, unsigned, rnd, wrap, grey, "sum of the 15x15 window of I, exact")           \
  X(colour_box_small, 22, 14, unsigned, rnd, wrap, one, "sum of the 7x7 window of a colour, exact")         \
  X(colour_box_large, 24, 14, unsigned, rnd, wrap, one, "sum of the 15x15 window of a colour, exact")       \
  X(intensity_contrast, 18, 3, unsigned, rnd, wrap, grey21, "on or off of I at one level, both radii")      \
  X(colour_contrast, 18, 11, unsigned, rnd, wrap, colour21, "on of a colour at one level, both radii")      \
  /* orientation, spec 5 */                                                                                 \
  X(gabor_column, 16, -8, signed, rnd, wrap, grey, "vertical 1-D sums of I: filters E, O, C, S, G")         \
  X(gabor_response, 20, -17, unsigned, rnd, wrap, grey, "magnitude of an even or odd 2-D sum")              \
  X(gabor_scale, 16, 42, unsigned, rnd, wrap, one, "1 / sum of absolute values of an integer 2-D window")   \
  X(gabor_energy, 18, 8, unsigned, rnd, wrap, grey, "|even| + |odd| at one level")                          \
  /* across scales, spec 6 */                                                                               \
  X(intensity_partial, 18, 2, unsigned, rnd, wrap, grey21, "levels 4 and 3 summed, size of level 3")        \
  X(colour_partial, 18, 10, unsigned, rnd, wrap, colour21, "levels 4 and 3 summed, size of level 3")        \
  X(orientation_partial, 18, 7, unsigned, rnd, wrap, grey, "levels 4 and 3 summed, size of level 3")        \
  X(intensity_sum, 21, 4, unsigned, rnd, wrap, grey21,                                                      \
    "levels 4 to 2 summed, exact: local maxima are found here")                                             \
  X(colour_sum, 21, 12, unsigned, rnd, wrap, colour21,                                                      \
    "levels 4 to 2 summed, exact: local maxima are found here")                                             \
  X(orientation_sum, 21, 9, unsigned, rnd, wrap, grey,                                                      \
    "levels 4 to 2 summed, exact: local maxima are found here")                                             \
  X(intensity_feature, 16, -1, unsigned, rnd, wrap, grey21, "feature maps intensity_on, intensity_off")     \
  X(colour_feature, 16, 7, unsigned, rnd, wrap, colour21, "feature maps green, blue, red, yellow")          \
  X(orientation_feature, 16, 4, unsigned, rnd, wrap, grey, "feature maps ori_0, ori_45, ori_90, ori_135")   \
  /* normalisation, spec 7 */                                                                               \
  X(maxima_count, 19, 0, unsigned, rnd, wrap, one, "m, local maxima above half the maximum")                \
  X(square_root, 18, 17, unsigned, trn, wrap, block, "sqrt(m), scaled to [1, 2)")                           \
  X(gain, 16, 16, unsigned, trn, sat, block, "1 / (max sqrt(m)), both scaled to [1, 2); below 1")           \
  X(normalised, 20, 20, unsigned, trn, wrap, one, "a feature map divided by max sqrt(m)")                   \
  X(intensity_conspicuity_sum, 21, 20, unsigned, rnd, wrap, one, "C_I, exact: local maxima are found here") \
  X(colour_conspicuity_sum, 22, 20, unsigned, rnd, wrap, one, "C_C, exact: local maxima are found here")    \
  X(orientation_conspicuity_sum, 22, 20, unsigned, rnd, wrap, one,                                          \
    "C_O, exact: local maxima are found here")                                                              \
  X(intensity_conspicuity, 16, 15, unsigned, trn, wrap, one, "C_I before its own normalisation")            \
  X(colour_conspicuity, 16, 14, unsigned, trn, wrap, one, "C_C before its own normalisation")               \
  X(orientation_conspicuity, 16, 14, unsigned, trn, wrap, one, "C_O before its own normalisation")          \
  X(normalised_conspicuity, 20, 20, unsigned, trn, wrap, one, "a conspicuity map divided by max sqrt(m)")   \
  X(saliency, 16, 14, unsigned, rnd, wrap, one, "S")                                                        \
  /* signature, spec 8 */                                                                                   \
  X(stop_ratio, 17, 16, unsigned, rnd, wrap, one, "the part of MSR at which no more regions are taken")     \
  X(intensity_region_sum, 24, -1, unsigned, rnd, wrap, grey21, "a feature map over a region, exact")        \
  X(colour_region_sum, 24, 7, unsigned, rnd, wrap, colour21, "a feature map over a region, exact")          \
  X(orientation_region_sum, 24, 4, unsigned, rnd, wrap, grey, "a feature map over a region, exact")         \
  X(intensity_conspicuity_region_sum, 24, 15, unsigned, rnd, wrap, one, "C_I over a region, exact")         \
  X(colour_conspicuity_region_sum, 24, 14, unsigned, rnd, wrap, one, "C_C over a region, exact")            \
  X(orientation_conspicuity_region_sum, 24, 14, unsigned, rnd, wrap, one, "C_O over a region, exact")       \
  X(normalised_region_sum, 40, 32, unsigned, trn, wrap, one,                                                \
    "a feature map over a region divided by max sqrt(m)")                                                   \
  X(descriptor_entry, 25, 16, unsigned, rnd, wrap, one, "v_i")

namespace sailmap {
namespace hls {

// Units that are no power of two save divisions: normalisation (eq. 1) divides a map by its own maximum,
// which cancels the unit.
namespace unit {
constexpr double one = 1;
constexpr double grey = 1.0 / 765;  // intensity is kept as s = r+g+b
// Contrasts divide by 48 and 224, whose common denominator is 672 = 32 * 21: the 21 stays in the unit.
constexpr double grey21 = 1.0 / (765 * 21);
constexpr double colour21 = 1.0 / 21;
constexpr double block = 1;  // times a power of two chosen for the number: gain() in arithmetic.hpp
}  // namespace unit

// Every point is a type of its own, so that its name can be given where it is used.
namespace formats {
#define SAILMAP_DECLARE_FORMAT(name_, word, fraction, sign, rounding, overflow, unit_name, what)   \
  struct name_ : Format<word, fraction, Sign::is_##sign, Rounding::rounding, Overflow::overflow> { \
    static constexpr const char* name() { return #name_; }                                         \
    static constexpr double unit() { return hls::unit::unit_name; }                                \
  };
SAILMAP_FORMAT_TABLE(SAILMAP_DECLARE_FORMAT)
#undef SAILMAP_DECLARE_FORMAT
}  // namespace formats

}  // namespace hls
}  // namespace sailmap
