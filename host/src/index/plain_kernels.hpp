// The kernels without vector instructions: for processors that have none of those Highway uses, and what the
// vectorised ones are tested against.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernels.hpp"

namespace sailmap::index::plain {

// Two codes next to each other: their squares, summed.
inline int square(const std::uint8_t* codes) {
  const auto x = static_cast<std::int8_t>(codes[0]);
  const auto y = static_cast<std::int8_t>(codes[1]);
  return x * x + y * y;
}

// Their products with the two bytes in `pair` counted from `origin`, the sum of the unsigned ones as far as
// signed 16 bits go.
inline int product(const std::uint8_t* codes, std::int16_t pair, int origin) {
  const auto x = static_cast<std::int8_t>(codes[0]);
  const auto y = static_cast<std::int8_t>(codes[1]);
  const auto bytes = static_cast<std::uint16_t>(pair);
  const int sum = x * static_cast<int>(bytes & 0xFFU) + y * static_cast<int>(bytes >> 8U);
  return std::clamp<int>(sum, INT16_MIN, INT16_MAX) - origin * (x + y);
}

inline std::uint16_t least_distance(const Block& block, const ScreenQuery& query, const ScreenRegion& region,
                                    std::size_t lane) {
  const bool exact = query.exact_positions && block.exact_positions;
  const auto count = static_cast<std::size_t>(block.counts[lane]);
  std::int16_t least = INT16_MAX;  // less the rest
  for (std::size_t slot = 0; slot < count; ++slot) {
    const std::uint8_t* c = block.codes.data() + slot * Block::slot_bytes + 2 * lane;
    int distance = 0;
    std::size_t i = 0;
    for (; i < direction_rows; ++i, c += Block::row_bytes) {
      distance += square(c) - product(c, region.pairs[i], direction_origin);
    }
    const int offset = square(c) / 2 - product(c, region.pairs[i], position_zero) - position_bias;
    if (static_cast<std::int16_t>(offset) >= region.position_limits[exact ? 0 : 1]) continue;
    least = std::min(least, static_cast<std::int16_t>(distance));
  }
  return static_cast<std::uint16_t>(std::max<int>(least, -region.descriptor_rest) + region.descriptor_rest);
}

inline std::uint8_t least_bound(const Block& block, const ScreenQuery& query, const ScreenRegion& region,
                                std::size_t lane) {
  const auto least = static_cast<float>(least_distance(block, query, region, lane));
  const float code = std::sqrt(least) * query.scale - region.error;
  return static_cast<std::uint8_t>(std::clamp(code, 0.0F, 255.0F));
}

inline bool within_limits(const Block& block, const ScreenQuery& query, std::size_t lane) {
  if (query.one_is_enough) {
    return std::any_of(query.regions.begin(), query.regions.end(), [&](const ScreenRegion& region) {
      return least_distance(block, query, region, lane) <= region.squared_limit;
    });
  }
  std::vector<int> bounds;
  for (const ScreenRegion& region : query.regions) bounds.push_back(least_bound(block, query, region, lane));
  std::sort(bounds.begin(), bounds.end());
  int sum = 0;
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    sum = std::min(sum + bounds[k], 65535);
    if (sum <= query.limits[k]) return true;
  }
  return false;
}

inline std::uint64_t screen(const Block& block, const ScreenQuery& query) {
  std::uint64_t passing = 0;
  for (std::size_t lane = 0; lane < block_images; ++lane) {
    passing |= static_cast<std::uint64_t>(within_limits(block, query, lane)) << lane;
  }
  return passing;
}

struct NearestOne {
  float least = no_candidate;
  float second = no_candidate;
  float dx = 0;
  float dy = 0;
};

inline NearestOne nearest(const QueryLanes& lanes, std::size_t lane, const Region* candidates,
                          std::size_t count) {
  NearestOne out;
  for (std::size_t j = 0; j < count; ++j) {
    const Region& to = candidates[j];
    const float dx = lanes.x[lane] - to.x;
    const float dy = lanes.y[lane] - to.y;
    if (dx * dx + dy * dy > lanes.largest_squared_offset) continue;
    float squared = 0;
    for (std::size_t k = 0; k < feature_count; ++k) {
      const float difference = lanes.descriptor[k][lane] - to.descriptor[k];
      squared += difference * difference;
    }
    if (squared < out.least) {
      out = {squared, out.least, dx, dy};
    } else {
      out.second = std::min(out.second, squared);
    }
  }
  return out;
}

inline ConsistentMatches consistent(const QueryLanes& lanes, const Region* candidates, std::size_t count,
                                    EstimateWork& /*work*/) {
  std::vector<NearestOne> matches;  // in the order of the query's regions
  for (const std::size_t lane : lanes.order) {
    const NearestOne found = nearest(lanes, lane, candidates, count);
    if (found.least >= no_candidate) continue;
    if (found.second <= found.least * (1 + ambiguous_part) + underflow) return {0, 0, true};
    matches.push_back(found);
  }
  ConsistentMatches most;
  for (const NearestOne& common : matches) {
    ConsistentMatches agreeing;
    for (const NearestOne& match : matches) {
      const float ex = match.dx - common.dx;
      const float ey = match.dy - common.dy;
      if (ex * ex + ey * ey > lanes.largest_squared_spread) continue;
      agreeing.sum += std::sqrt(std::max(0.0F, match.least - underflow));
      ++agreeing.count;
    }
    if (agreeing.count > most.count) most = agreeing;
  }
  return most;
}

}  // namespace sailmap::index::plain
