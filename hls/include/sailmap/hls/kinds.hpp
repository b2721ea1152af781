// The kinds of maps, in the order of spec section 6, and the pairs of maps that travel in one word before
// they are rounded for the stores: they tell the instances of a stage apart.
//
// The stores replay the feature maps twice, so that no conspicuity map need be stored: the first pass puts
// them out and finds maximum and m of the conspicuity maps, the second puts these out and makes saliency of
// them.
#pragma once

#include <cstdint>

namespace sailmap {
namespace hls {

constexpr int intensity_kind = 0;
constexpr int colour_kind = 1;
constexpr int orientation_kind = 2;
constexpr int conspicuity_kind = 3;

constexpr int on_off_pair = 0;
constexpr int green_blue_pair = 1;
constexpr int red_yellow_pair = 2;
constexpr int ori_0_45_pair = 3;
constexpr int ori_90_135_pair = 4;
constexpr int intensity_colour_pair = 5;  // C_I, C_C
constexpr int orientation_pair = 6;       // C_O alone

constexpr int passes = 2;
constexpr int passes_of_pair(int pair) { return pair >= intensity_colour_pair ? passes : 1; }

// Flags of a pixel on its way to a store, beside those of four maps: of a frame's first pixel, and of its
// last but one. They come with a store's first pair.
constexpr uint8_t start_of_frame = 16;
constexpr uint8_t last_but_one = 32;
constexpr bool marks_frames(int pair) {
  return pair == on_off_pair || pair == green_blue_pair || pair == ori_0_45_pair;
}

}  // namespace hls
}  // namespace sailmap
