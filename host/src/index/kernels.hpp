// The inner loops, in the best instruction set of the processor at hand (Highway's dispatch at run time).
#pragma once

#include <cstddef>
#include <cstdint>

#include "screen.hpp"

namespace sailmap::index {

// A bit for each image of the block that passes. `work` holds at least work_bytes(slots, regions).
std::uint64_t screen_block(const Block& block, const ScreenQuery& query, std::uint8_t* work);
std::size_t work_bytes(std::size_t slots, std::size_t regions);

// For each query region the least squared distance to an admissible candidate, or a number above 1e30 where
// there is none; lanes.x.size() floats.
void nearest_squared(const QueryLanes& lanes, const Region* candidates, std::size_t count, float* nearest);
inline constexpr std::size_t lane_padding = 16;

}  // namespace sailmap::index
