// Geometry of the front end: which sizes and levels exist, shared by the kernels, the reference and the host.
//
// Source: spec sections 1, 3-6 and 8. Everything is constexpr and C++14, so that a wrong size stops the
// compiler where it is known at compile time. Sizes are in pixels of the level named.
#pragma once

namespace sailmap {
namespace hls {
namespace geometry {

constexpr int min_image_side = 64;
constexpr int max_image_side = 4096;

// Pyramid levels that carry maps (spec 1): the base level is the finest of them.
constexpr int base_level = 2;
constexpr int top_level = 4;
constexpr int map_levels = top_level - base_level + 1;
// One base-level pixel is this many level-0 pixels wide and high.
constexpr int base_scale = 1 << base_level;

// Centre-surround radii (spec 4) and the Gabor window (spec 5), in pixels of their level.
constexpr int surround_radius_small = 3;
constexpr int surround_radius_large = 7;
constexpr int gabor_taps = 9;
constexpr int gabor_radius = gabor_taps / 2;

constexpr int intensity_maps = 2;
constexpr int colour_maps = 4;
constexpr int orientation_maps = 4;
constexpr int feature_maps = intensity_maps + colour_maps + orientation_maps;
constexpr int conspicuity_maps = 3;

// ceil(n / 2): the even samples of n, which one reduction keeps (spec 3).
constexpr int half(int n) { return (n + 1) / 2; }

// Side of pyramid level `level` of an image whose side is n: ceil(n / 2^level), which is half() `level`
// times. In closed form, for Bambu: its front end never ends on a recursive function (docs/fpga.md).
constexpr int level_side(int n, int level) { return (n + (1 << level) - 1) >> level; }

// Side of the base level, the size of all feature, conspicuity and saliency maps.
constexpr int base_side(int n) { return level_side(n, base_level); }

// Pixels of the base level to one of level `level`.
constexpr int area_ratio(int level) { return 1 << (2 * (level - base_level)); }

// The most local maxima of a map: of a square of two by two pixels one at most is one.
constexpr int most_maxima(int width, int height) { return half(width) * half(height); }

// The ones of the shortest binary number that n, up to 2^16 - 1, fits in.
constexpr int ones(int n) {
  int bits = 1;
  while (bits < n) bits = 2 * bits + 1;
  return bits;
}

constexpr bool valid_side(int n) { return n >= min_image_side && n <= max_image_side; }

}  // namespace geometry
}  // namespace hls
}  // namespace sailmap
