// The inner loops, in the best instruction set of the processor at hand (Highway's dispatch at run time).
#pragma once

#include <cstddef>
#include <cstdint>

#include "agreement.hpp"
#include "estimate.hpp"
#include "screen.hpp"

namespace sailmap::index {

// Squared distance, in 16 bits, where there is no admissible candidate: no distance is more.
inline constexpr std::uint16_t no_distance = UINT16_MAX;

// See ScreenQuery::passing. `next` is fetched from memory meanwhile. `work` holds at least work_bytes(slots,
// regions).
std::uint64_t screen_block(const Block& block, const Block& next, const ScreenQuery& query,
                           std::uint8_t* work);
std::size_t work_bytes(std::size_t slots, std::size_t regions);

// See AgreementQuery::passing. `work` has a slot for each of the batch's, and a `nearest` for each region.
std::uint32_t agreeing_images(const Batch& batch, const AgreementQuery& query, AgreementWork& work);

// Squared code steps: a true squared distance is below the codes' (rounded down) by less than one, before
// their errors, and has what sums of shares may differ.
inline constexpr auto room_above = static_cast<float>(1.001 + largest_squared_rest / (step * step));
inline constexpr float rounding_room = 1.0001F;  // of what is above 1
inline constexpr float most_distance = no_distance - 1;

// Both constraints. `work.numbers` holds 5 * lanes.x.size() numbers, the rest grows as needed.
ConsistentMatches consistent_matches(const QueryLanes& lanes, const Region* candidates, std::size_t count,
                                     EstimateWork& work);

// Half the squared offset of two positions, less |q|^2/2, is from -16130 to 48387, as they are at most
// position_zero from their zero in both directions: less this it has signed 16 bits.
inline constexpr int position_bias = 16638;
// What directions of the query are counted from.
inline constexpr int direction_origin = 128;

// Two squared distances within this part of each other are too near for single precision to order.
inline constexpr float ambiguous_part = 1e-5F;
// What underflow can lose of a squared distance.
inline constexpr float underflow = 1e-37F;
// Squared distance where there is no admissible candidate, above all others.
inline constexpr float no_candidate = 1e31F;

}  // namespace sailmap::index
