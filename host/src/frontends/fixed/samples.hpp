// How the `fixed` front end holds the samples of the pyramid.
#pragma once

#include <cstdint>

#include "sailmap/hls/formats.hpp"

namespace sailmap::fixed {

namespace formats = hls::formats;

// Raw words of 16 bits less 2^15, so that they are signed: processors multiply pairs of signed 16-bit numbers
// and add them to 32 bits in one instruction. A filter whose weights have the sum W is then off by W 2^15;
// centre-surround, whose weights have the sum 0, does not notice.
using Sample = std::int16_t;
constexpr int bias = 1 << 15;
static_assert(formats::intensity::word == 16 && formats::colour::word == 16);

// Level 0 of intensity is held in its own, coarser unit; less this it reduces to samples as the others do.
constexpr int grey_bias = bias >> (formats::intensity::fraction - formats::grey_sum::fraction);
static_assert(grey_bias << (formats::intensity::fraction - formats::grey_sum::fraction) == bias);

// Planes of one pyramid level, in this order everywhere: intensity, then the colours as their feature maps.
enum Channel { intensity, green, blue, red, yellow };
constexpr int channel_count = 5;

}  // namespace sailmap::fixed
