// Spec section 7, eq. 1: m, the number of local maxima above half the maximum.
#pragma once

#include <cstdint>

#include "across_scales.hpp"
#include "sailmap/hls/requantise.hpp"

namespace sailmap::fixed {

// Local maxima of `sums` that are at least `least`. A plane holds -1 around it, below all sums.
std::uint32_t count_local_maxima(const SumPlane& sums, std::int32_t least);

// The least sum whose rounded value is above half of `maximum`, a rounded value too.
template <class Sum, class Rounded>
constexpr std::int32_t least_above_half(std::uint32_t maximum) {
  constexpr int shift = Sum::fraction - Rounded::fraction;
  static_assert(shift > 0 &&
                (Rounded::rounding == hls::Rounding::rnd || Rounded::rounding == hls::Rounding::trn));
  const auto least_rounded = static_cast<std::int32_t>(maximum / 2 + 1);
  constexpr std::int32_t offset = Rounded::rounding == hls::Rounding::rnd ? 1 << (shift - 1) : 0;
  return (least_rounded << shift) - offset;
}

}  // namespace sailmap::fixed
