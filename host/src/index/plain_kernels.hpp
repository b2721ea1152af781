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

// Half the squared size of a candidate's codes about their zeros, rounded down, less their product with the
// query's: half the squared distance, less half the square of the query's.
inline int half_distance(const Block& block, std::size_t slot, std::size_t lane, const ScreenRegion& region,
                         std::size_t begin, const std::vector<int>& zeros) {
  int square = 0;
  int product = 0;
  for (std::size_t i = begin; i < begin + zeros.size(); ++i) {
    const std::size_t row = slot * Block::slot_bytes + i / 2 * Block::row_bytes;
    const int c = block.codes[row + 2 * lane + i % 2] - zeros[i - begin];
    const auto pair = static_cast<std::uint16_t>(region.minus_pairs[i / 2]);
    const auto minus_q = static_cast<std::int8_t>(i % 2 == 0 ? pair & 0xFFU : pair >> 8U);
    square += c * c;
    product += c * minus_q;
  }
  return square / 2 + product;
}

inline int half_square_of_descriptor(const ScreenRegion& region) {
  int square = 0;
  for (std::size_t i = 0; i < directions; ++i) {
    const auto pair = static_cast<std::uint16_t>(region.minus_pairs[i / 2]);
    const auto q = static_cast<std::int8_t>(i % 2 == 0 ? pair & 0xFFU : pair >> 8U);
    square += q * q;
  }
  return square / 2;
}

inline std::uint8_t least_bound(const Block& block, const ScreenQuery& query, const ScreenRegion& region,
                                std::size_t lane) {
  const auto pair = static_cast<std::uint16_t>(query.position_zeros);
  const std::vector<int> position_zeros = {static_cast<int>(pair & 0xFFU), static_cast<int>(pair >> 8U)};
  const std::vector<int> descriptor_zeros(directions, zero_code);
  const bool exact = query.exact_positions && block.exact_positions;
  const auto count = static_cast<std::size_t>(block.counts[lane]);
  int least = INT16_MAX;
  for (std::size_t slot = 0; slot < count; ++slot) {
    const int offset = half_distance(block, slot, lane, region, directions, position_zeros);
    if (offset >= region.position_limits[exact ? 0 : 1]) continue;
    const int distance =
        half_distance(block, slot, lane, region, 0, descriptor_zeros) + half_square_of_descriptor(region);
    least = std::min<int>(least, static_cast<std::int16_t>(distance));
  }
  const auto squared = static_cast<float>(std::max(least, 0));
  const float code = std::sqrt(squared + squared) * query.scale - region.error;
  return static_cast<std::uint8_t>(std::clamp(code, 0.0F, 255.0F));
}

inline Passing screen(const Block& block, const ScreenQuery& query, std::uint8_t* /*work*/) {
  Passing passing{};
  std::vector<int> bounds(query.regions.size());
  for (std::size_t lane = 0; lane < block_images; ++lane) {
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      bounds[i] = least_bound(block, query, query.regions[i], lane);
    }
    std::sort(bounds.begin(), bounds.end());
    for (std::size_t grade = 0; grade < grades; ++grade) {
      int sum = 0;
      bool passes = false;
      for (std::size_t k = 0; k < bounds.size(); ++k) {
        sum = std::min(sum + bounds[k], 65535);
        passes = passes || sum <= query.limits[k][grade];
      }
      passing[grade] |= static_cast<std::uint64_t>(passes) << lane;
    }
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
