// The kinds of maps, in the order of spec section 6, and the pairs of maps that travel in one word before
// they are rounded for the stores: they tell the instances of a stage apart.
#pragma once

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

}  // namespace hls
}  // namespace sailmap
