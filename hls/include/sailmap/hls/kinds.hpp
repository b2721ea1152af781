// The kinds of maps, in the order of spec section 6: they tell the instances of a stage apart.
#pragma once

namespace sailmap {
namespace hls {

constexpr int intensity_kind = 0;
constexpr int colour_kind = 1;
constexpr int orientation_kind = 2;
constexpr int conspicuity_kind = 3;

}  // namespace hls
}  // namespace sailmap
