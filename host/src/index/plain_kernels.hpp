// The kernels without vector instructions: for processors that have none of those Highway uses, and what the
// vectorised ones are tested against.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernels.hpp"

namespace sailmap::index::plain {

inline int saturated(int sum) { return std::min(sum, 255); }

// As bytes of one image in one slot: the eight code numbers.
inline std::array<std::uint8_t, code_numbers> numbers_of(const Block& block, std::size_t slot,
                                                         std::size_t lane) {
  std::array<std::uint8_t, code_numbers> out{};
  for (std::size_t byte = 0; byte < code_bytes; ++byte) {
    const std::uint8_t packed = block.codes[(slot * code_bytes + byte) * block_images + lane];
    out[2 * byte] = packed & 0x0FU;
    out[2 * byte + 1] = static_cast<std::uint8_t>(packed >> 4U);
  }
  return out;
}

inline int root(int squared, const std::array<std::uint8_t, 48>& roots) {
  const int entry = squared < 16 ? squared : squared < 64 ? 16 + squared / 4 : 32 + squared / 16;
  return roots[static_cast<std::size_t>(entry)];
}

inline int least_bound(const Block& block, const ScreenQuery& query, std::size_t region, std::size_t lane) {
  const auto& tables = query.tables[region];
  int least = 255;
  for (std::size_t slot = 0; slot < block.slots(); ++slot) {
    const auto number = numbers_of(block, slot, lane);
    int squared = 0;
    for (std::size_t i = 0; i < directions; ++i) squared = saturated(squared + tables[i][number[i]]);
    const int position =
        tables[directions][number[directions]] + tables[directions + 1][number[directions + 1]];
    if (position < 128) least = std::min(least, squared);
  }
  return root(least, query.roots);
}

inline std::uint64_t screen(const Block& block, const ScreenQuery& query, std::uint8_t* /*work*/) {
  std::uint64_t passing = 0;
  std::vector<int> bounds(query.tables.size());
  for (std::size_t lane = 0; lane < block_images; ++lane) {
    for (std::size_t i = 0; i < bounds.size(); ++i) bounds[i] = least_bound(block, query, i, lane);
    std::sort(bounds.begin(), bounds.end());
    int sum = 0;
    bool passes = false;
    for (std::size_t k = 0; k < bounds.size(); ++k) {
      sum = std::min(sum + bounds[k], 65535);
      passes = passes || sum <= query.limits[k];
    }
    passing |= static_cast<std::uint64_t>(passes) << lane;
  }
  return passing;
}

inline void nearest(const QueryLanes& lanes, const Region* candidates, std::size_t count, float* out) {
  std::fill_n(out, lanes.x.size(), 1e31F);
  for (std::size_t i = 0; i < lanes.count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      const Region& to = candidates[j];
      const float dx = lanes.x[i] - to.x;
      const float dy = lanes.y[i] - to.y;
      if (!(dx * dx + dy * dy <= lanes.squared_radius)) continue;
      float sum = 0;
      for (std::size_t k = 0; k < feature_count; ++k) {
        const float difference = lanes.descriptor[k][i] - to.descriptor[k];
        sum += difference * difference;
      }
      out[i] = std::min(out[i], sum);
    }
  }
}

}  // namespace sailmap::index::plain
