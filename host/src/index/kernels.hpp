// The inner loops, in the best instruction set of the processor at hand (Highway's dispatch at run time).
#pragma once

#include <cstddef>
#include <cstdint>

#include "estimate.hpp"
#include "screen.hpp"

namespace sailmap::index {

// See ScreenQuery::passing. `work` holds at least work_bytes(slots, regions).
Passing screen_block(const Block& block, const ScreenQuery& query, std::uint8_t* work);
std::size_t work_bytes(std::size_t slots, std::size_t regions);

// Both constraints. `work.numbers` holds 5 * lanes.x.size() numbers, the rest grows as needed.
ConsistentMatches consistent_matches(const QueryLanes& lanes, const Region* candidates, std::size_t count,
                                     EstimateWork& work);

// Half the squared offset of two positions, less |q|^2/2, is from -16130 to 48387, as they are at most
// position_zero from their zero in both directions: less this it has signed 16 bits.
inline constexpr int position_bias = 16638;
// Half the squared position code of an empty slot, whose position is the zeros: what is added to it comes to
// nothing but the bias, and it is above all limits, which are at most INT16_MAX.
inline constexpr std::int16_t empty_slot = static_cast<std::int16_t>(INT16_MAX + position_bias - 65536);

// Squared distance, in 16 bits, where there is no admissible candidate: no distance is more.
inline constexpr std::uint16_t no_distance = UINT16_MAX;

// Two squared distances within this part of each other are too near for single precision to order.
inline constexpr float ambiguous_part = 1e-5F;
// What underflow can lose of a squared distance.
inline constexpr float underflow = 1e-37F;
// Squared distance where there is no admissible candidate, above all others.
inline constexpr float no_candidate = 1e31F;

}  // namespace sailmap::index
