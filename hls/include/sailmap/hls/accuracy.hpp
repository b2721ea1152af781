// How far the fixed-point design may be from the exact reference: stated here, asserted by the tests,
// measured in docs/accuracy.md. All errors in the spec's units.
//
// Two kinds of number. A `bound` holds for every image: half a unit of each rounding, carried through the
// filters at their worst. A `photographs` number is the largest seen on the two real sequences, rounded up;
// roundings average out there. After the feature maps no bound exists: m of eq. 1 counts peaks above half the
// maximum, and a peak at the threshold counts or not. What is stated for conspicuity and saliency is for
// images whose m all agree.
#pragma once

#include "sailmap/hls/formats.hpp"
#include "sailmap/hls/gabor_coefficients.hpp"
#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/ranges.hpp"

namespace sailmap {
namespace hls {
namespace accuracy {

constexpr double power_of_two(int exponent) {
  double value = 1;
  for (int i = 0; i < exponent; ++i) value *= 2;
  for (int i = 0; i > exponent; --i) value /= 2;
  return value;
}

// What one unit of a raw integer of format F is worth.
template <class F>
constexpr double lsb() {
  return F::unit() * power_of_two(-F::fraction);
}

// --- Every image ---

// A pyramid level keeps the error of the level before, in the mean, and adds its own rounding.
constexpr double level_error(double level_0, double lsb_of_level, int level) {
  return level_0 + level * lsb_of_level / 2;
}
// k is off by half its unit and multiplies at most 2 * 255.
constexpr double colour_error = 510 * lsb<formats::colour_reciprocal>() / 2 + lsb<formats::colour>() / 2;

// centre - surround is off by at most twice the level's error, and there are two radii.
template <class Level, class Contrast>
constexpr double contrast_error(double level_0, int level) {
  return 4 * level_error(level_0, lsb<Level>(), level) + lsb<Contrast>() / 2;
}
template <class Contrast, class Partial, class Feature, class Level>
constexpr double contrast_feature_error(double level_0) {
  return contrast_error<Level, Contrast>(level_0, 2) + contrast_error<Level, Contrast>(level_0, 3) +
         contrast_error<Level, Contrast>(level_0, 4) + lsb<Partial>() / 2 + lsb<Feature>() / 2;
}

// Of one window: its coefficients, on an input that spans [0, 1], half of it above the mean the window does
// not see; the level's error; half a unit in every column, half a unit of the response, half a unit of the
// scale on a response of 1/2.
constexpr double window_error(int level, double window_scale, double column_weight) {
  return gabor::max_window_error / 2 + level_error(0, lsb<formats::intensity>(), level) +
         (column_weight * lsb<formats::gabor_column>() + lsb<formats::gabor_response>()) / 2 / window_scale +
         lsb<formats::gabor_scale>() / 2 * window_scale / 2;
}
constexpr double gabor_level_error(int level) {
  double largest = 0;
  for (int i = 0; i < geometry::orientation_maps; ++i) {
    const double both = window_error(level, static_cast<double>(gabor::even_scale(i)),
                                     static_cast<double>(ranges::column_weight(i, true))) +
                        window_error(level, static_cast<double>(gabor::odd_scale(i)),
                                     static_cast<double>(ranges::column_weight(i, false)));
    largest = both > largest ? both : largest;
  }
  return largest + lsb<formats::gabor_energy>() / 2;
}

constexpr double intensity_feature_bound =
    contrast_feature_error<formats::intensity_contrast, formats::intensity_partial,
                           formats::intensity_feature, formats::intensity>(0);
constexpr double colour_feature_bound =
    contrast_feature_error<formats::colour_contrast, formats::colour_partial, formats::colour_feature,
                           formats::colour>(colour_error);
constexpr double orientation_feature_bound = gabor_level_error(2) + gabor_level_error(3) +
                                             gabor_level_error(4) + lsb<formats::orientation_partial>() / 2 +
                                             lsb<formats::orientation_feature>() / 2;

// An entry v_i of a descriptor against eq. 3-4 in real numbers on the same maps with the same statistics, at
// most this share of it and this bound together. The share: a gain has at least 14 bits, truncated, and its
// root, truncated too, errs the other way. The bound: a normalised sum is truncated to 2^-32 and divided by a
// conspicuity sum of at least one unit, 2^-15, and the entry is rounded.
constexpr double descriptor_share = power_of_two(-(formats::gain::word - 2));
constexpr double descriptor_bound =
    lsb<formats::normalised_region_sum>() / lsb<formats::intensity_conspicuity_region_sum>() +
    lsb<formats::descriptor_entry>() / 2;

// --- Photographs ---

constexpr double intensity_feature_photographs = 1.6e-4;
constexpr double colour_feature_photographs = 5.5e-4;
constexpr double orientation_feature_photographs = 1.3e-4;

// An entry of the chip's descriptors against the host's, of the same maps.
constexpr double descriptor_photographs = 1e-4;

// Of the map's own maximum, where that maximum is at least the floor: a map that is nearly flat has nothing
// to be a percentage of, and there the absolute errors above are what holds. Full scale is 6, 18 and 3.
constexpr double feature_share = 0.002;
constexpr double intensity_feature_floor = 0.08;
constexpr double colour_feature_floor = 0.275;
constexpr double orientation_feature_floor = 0.065;

// Of the map's own maximum, in images where every m agrees.
constexpr double conspicuity_share = 0.005;
constexpr double saliency_share = 0.005;

// Of the five most salient regions of each image of a real sequence, so many are at the very same base-level
// pixel.
constexpr double region_agreement = 0.97;

// Average precision of a real sequence, at most so far from that with the exact maps.
constexpr double average_precision_change = 0.01;

// The same with the chip's signatures against the host's, of the same maps.
constexpr double chip_average_precision_change = 0.001;

}  // namespace accuracy
}  // namespace hls
}  // namespace sailmap
