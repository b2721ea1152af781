// Spec section 7: maps normalised by eq. 1 and summed: conspicuities and saliency, eq. 2.
#pragma once

#include <cstdint>
#include <span>

#include "across_scales.hpp"
#include "sailmap/hls/arithmetic.hpp"

namespace sailmap::fixed {

// A stored map of base-level size, unpadded, and its gain.
struct GainedMap {
  const std::uint16_t* samples;
  hls::Gain gain;
};

// The conspicuity of intensity (2 maps), of colour (4) or of orientation (4): the exact sums of the
// normalised maps, and the stored map. `sums` has its size. Returns the largest sum.
std::int32_t intensity_conspicuity(std::span<const GainedMap> maps, SumPlane& sums, std::uint16_t* stored);
std::int32_t colour_conspicuity(std::span<const GainedMap> maps, SumPlane& sums, std::uint16_t* stored);
std::int32_t orientation_conspicuity(std::span<const GainedMap> maps, SumPlane& sums, std::uint16_t* stored);

// S of the three conspicuities, `width` x `height`.
void saliency(std::span<const GainedMap> maps, int width, int height, std::uint16_t* stored);

}  // namespace sailmap::fixed
