// Arithmetic policies of the reference. The reference calls `Policy::at<Point>(value)` at every named point
// of the hardware; the policy decides what a number looks like there. `Exact` keeps the double as it is.
#pragma once

#include <cmath>
#include <type_traits>

namespace sailmap::ref {

// The named points (spec 9): each is a place where the fixed-point design rounds.
namespace point {
struct colour_reciprocal;   // 3 / (2 s), section 2
struct intensity;           // I and its pyramid, sections 2-3
struct colour;              // R, G, B, Y and their pyramids, sections 2-3
struct intensity_contrast;  // centre-surround of I, section 4
struct colour_contrast;     // centre-surround of R, G, B, Y, section 4
struct gabor_row;           // sums of the horizontal 1-D filters, section 5
struct gabor_energy;        // |even| + |odd|, section 5
struct intensity_feature;   // feature maps, section 6
struct colour_feature;
struct orientation_feature;
struct normalised;   // X~, section 7
struct conspicuity;  // C_I, C_C, C_O
struct normalised_conspicuity;
struct saliency;  // S
}  // namespace point

// Double precision in the spec's own units, on a grid of 2^-40. The grid is far below what a photograph's
// maps hold (1e-12 against 1e-2; a single grey level on a flat image still makes maps of 1e-6) and far above
// the rounding of a sum (1e-16): without it a flat image has contrasts of 1e-17, which eq. 1 would blow up to
// full saliency, and equal neighbours stop being equal. On the grid the sums of sections 3 and 4 are exact,
// 3 * 225 * 2^40 < 2^53, so their order does not matter.
struct Exact {
  static constexpr double grid = 0x1p-40;
  // Section 7: values this close, 64 roundings, may be equal but for the grid. Peaks of exactly half the
  // maximum do occur: where one of two maps has four times the maxima of the other and their peaks do not
  // overlap.
  static constexpr double tie = 64 * grid;

  // I = s / 765, in [0, 1].
  static double intensity(int s) { return s / 765.0; }

  template <class Point>
  static double at(double value) {
    // Multiplied by up to 510 afterwards, a reciprocal on the grid would be off by 2e-10, differently for
    // every s: one hue under changing light would have colour contrasts.
    if constexpr (std::is_same_v<Point, point::colour_reciprocal>) {
      return value;
    } else {
      return std::rint(value / grid) * grid;
    }
  }
};

}  // namespace sailmap::ref
