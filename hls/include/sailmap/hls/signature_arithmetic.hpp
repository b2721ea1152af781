// The declared steps of the arithmetic of signature.hpp, each a pure function of integers (see
// arithmetic.hpp).
#pragma once

#include <cstdint>

#include "sailmap/hls/arithmetic.hpp"
#include "sailmap/hls/formats.hpp"
#include "sailmap/hls/pragmas.hpp"

namespace sailmap {
namespace hls {

// --- Section 8, regions ---

// Whether a peak is no region any more, the strongest one being `first`; 0 never is one.
constexpr bool ends_search(std::uint32_t peak, std::uint32_t first, std::uint32_t stop_ratio, bool is_first) {
  return peak == 0 || (!is_first && (static_cast<std::uint64_t>(peak) << formats::stop_ratio::fraction) <=
                                        static_cast<std::uint64_t>(first) * stop_ratio);
}

// --- Section 8, eq. 3-4: a ratio of means over one region is a ratio of sums ---

// X~ over the region from the sum of the raw map, which is exact.
constexpr std::uint64_t normalised_region_sum(std::uint32_t sum, const Gain& g) {
  constexpr int finer = formats::normalised_region_sum::fraction - formats::gain::fraction;
  return (static_cast<std::uint64_t>(sum) * g.mantissa << finer) >> g.shift;
}

// Of the conspicuity sums in raw units: they divide v_i's numerator, shifted by what the points' fractions
// differ.
template <class ConspicuitySum>
constexpr std::uint32_t entry_divisor(std::uint32_t sum) {
  return sum << (formats::normalised_region_sum::fraction - formats::descriptor_entry::fraction -
                 ConspicuitySum::fraction);
}

// v_i: normalised / divisor, rounded to nearest, ties up; 0 where the divisor is. The quotient, below 2^25,
// bit by bit, a bit a turn.
constexpr int entry_turns = formats::descriptor_entry::word;
constexpr std::uint32_t descriptor_entry(std::uint64_t normalised, std::uint32_t divisor) {
  const std::uint64_t dividend = normalised + divisor / 2;
  auto rest = static_cast<std::uint32_t>(dividend >> entry_turns);
  auto bits = static_cast<std::uint32_t>(dividend & ((std::uint64_t{1} << entry_turns) - 1));
  std::uint32_t quotient = 0;
#pragma nounroll
  for (int i = 0; i < entry_turns; ++i) {
    rest = rest << 1 | (bits >> (entry_turns - 1) & 1U);
    bits <<= 1;
    quotient <<= 1;
    if (rest >= divisor) {
      rest -= divisor;
      quotient |= 1U;
    }
  }
  return divisor == 0 ? 0 : quotient;
}
static_assert(formats::descriptor_entry::rounding == Rounding::rnd &&
                  formats::normalised_region_sum::rounding == Rounding::trn,
              "the roundings written out above");

}  // namespace hls
}  // namespace sailmap
