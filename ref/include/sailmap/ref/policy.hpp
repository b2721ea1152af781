// Arithmetic policies of the reference. The reference calls `Policy::at<Point>(value)` at every named point of the
// hardware; the policy decides what a number looks like there. `Exact` keeps the double as it is.
#pragma once

#include <cmath>

namespace sailmap::ref {

// The named points (spec 9): each is a place where the fixed-point design rounds.
namespace point {
struct colour_reciprocal;    // 3 / (2 s), section 2
struct intensity;            // I and its pyramid, sections 2-3
struct colour;               // R, G, B, Y and their pyramids, sections 2-3
struct intensity_contrast;   // centre-surround of I, section 4
struct colour_contrast;      // centre-surround of R, G, B, Y, section 4
struct gabor_row;            // sums of the horizontal 1-D filters, section 5
struct gabor_energy;         // |even| + |odd|, section 5
struct intensity_feature;    // feature maps, section 6
struct colour_feature;
struct orientation_feature;
struct normalised;           // X~, section 7
struct conspicuity;          // C_I, C_C, C_O
struct normalised_conspicuity;
struct saliency;             // S
}  // namespace point

// Double precision in the spec's own units, on a grid of 2^-40. The grid is far below anything an 8-bit image can
// cause (1e-12 against 1e-9) and far above the rounding of a sum (1e-16): without it a flat image has contrasts of
// 1e-17, which eq. 1 would blow up to full saliency, and equal neighbours stop being equal.
struct Exact {
  static constexpr double grid = 0x1p-40;

  // I = s / 765, in [0, 1].
  static double intensity(int s) { return s / 765.0; }

  template <class Point>
  static double at(double value) {
    return std::rint(value / grid) * grid;
  }
};

}  // namespace sailmap::ref
