// Arithmetic policies of the reference. The reference calls `Policy::at<Point>(value)` at every named point
// of the hardware; the policy decides what a number looks like there. `Exact` (here) keeps the double as it
// is, `Quantised` (quantised.hpp) rounds it to the point's format.
#pragma once

#include <cmath>
#include <type_traits>

#include "sailmap/hls/formats.hpp"
#include "sailmap/ref/gabor_filters.hpp"

namespace sailmap::ref {

// The named points (spec 9): each is a place where the fixed-point design rounds.
namespace point = hls::formats;

// Double precision in the spec's own units, on a grid of 2^-40. The grid is far below what a photograph's
// maps hold (1e-12 against 1e-2; a single grey level on a flat image still makes maps of 1e-6) and far above
// the rounding of a sum (1e-16): without it a flat image has contrasts of 1e-17, which eq. 1 would blow up to
// full saliency, and equal neighbours stop being equal. On the grid the sums of sections 3 and 4 are exact (3
// x 225 x 2^40 < 2^53), so their order does not matter.
struct Exact {
  static constexpr double grid = 0x1p-40;
  // Section 7: two values this close may be equal but for the grid; 64 roundings. Peaks of exactly half the
  // maximum do occur: where one of two maps has four times the maxima of the other and their peaks do not
  // overlap.
  static constexpr double tie = 64 * grid;
  // Section 4: contrasts are summed in 672nds, the common denominator of 48 and 224.
  static constexpr double contrast_divisor = 672;

  // I = s / 765, in [0, 1].
  static double intensity(int s) { return s / 765.0; }

  template <class Point>
  static double at(double value) {
    // Multiplied by up to 510 afterwards, a reciprocal on the grid would be off by 2e-10, differently for
    // every s: one hue under changing light would have colour contrasts.
    if constexpr (std::is_same_v<Point, point::colour_reciprocal> ||
                  std::is_same_v<Point, point::gabor_scale>) {
      return value;
    } else {
      return std::rint(value / grid) * grid;
    }
  }

  static GaborFilters gabor_filters() { return spec_gabor_filters(); }

  // Section 7: 1 / (max sqrt(m)), 0 for a flat zero map.
  static double gain(double maximum, int maxima) {
    return maximum > 0 ? 1 / (maximum * std::sqrt(maxima)) : 0;
  }
};

}  // namespace sailmap::ref
