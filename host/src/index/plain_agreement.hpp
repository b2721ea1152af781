// What agreement_kernel.cpp computes, image by image without vector instructions: see plain_kernels.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "plain_kernels.hpp"

namespace sailmap::index::plain {

struct Displaced {
  int column = 0;
  int row = 0;
};

inline int squared_length(const Displaced& a) { return a.column * a.column + a.row * a.row; }

// The regions of a batch's image.
struct BatchImage {
  const Batch& batch;
  std::size_t lane = 0;

  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(batch.counts[lane]); }
  [[nodiscard]] const std::uint8_t* pair(std::size_t slot, std::size_t row) const {
    return batch.codes.data() + slot * Batch::slot_bytes + row * Batch::row_bytes + 2 * lane;
  }
};

// Squared distance above, displacement below.
inline std::vector<std::uint32_t> sorted_keys(const BatchImage& image, const AgreementRegion& region,
                                              int largest_squared_offset) {
  const auto place = static_cast<std::uint16_t>(region.place);
  const Displaced from{static_cast<std::int8_t>(place & 0xFFU), static_cast<std::int8_t>(place >> 8U)};
  std::vector<std::uint32_t> keys;
  for (std::size_t slot = 0; slot < image.count(); ++slot) {
    const std::uint8_t* position = image.pair(slot, direction_rows);
    const Displaced by{static_cast<std::int8_t>(position[0]) - from.column,
                       static_cast<std::int8_t>(position[1]) - from.row};
    if (squared_length(by) > largest_squared_offset) continue;
    int distance = region.screen.descriptor_rest;
    for (std::size_t i = 0; i < direction_rows; ++i) {
      const std::uint8_t* c = image.pair(slot, i);
      distance += square(c) - product(c, region.screen.pairs[i], direction_origin);
    }
    const std::uint32_t bytes = static_cast<std::uint8_t>(by.column) |
                                static_cast<std::uint32_t>(static_cast<std::uint8_t>(by.row)) << 8U;
    keys.push_back(static_cast<std::uint32_t>(static_cast<std::uint16_t>(distance)) << 16U | bytes);
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

// A region's nearest candidates.
struct Found {
  std::vector<Displaced> alternatives;
  int cost = 0;
};

inline Displaced displacement_of(std::uint32_t key) {
  return {static_cast<std::int8_t>(key & 0xFFU), static_cast<std::int8_t>((key >> 8U) & 0xFFU)};
}

inline Found found_of(const std::vector<std::uint32_t>& keys, float error, float cost_of_step) {
  Found out;
  if (keys.empty()) return out;
  const auto least = static_cast<float>(keys.front() >> 16U);
  const float above = std::sqrt(least + room_above) + 2 * error;
  const float limit = std::min(above * above * rounding_room, most_distance);
  const float below = std::max(std::sqrt(least) - error, 0.0F);
  out.cost = static_cast<int>(std::min<float>(below * cost_of_step, UINT16_MAX));
  for (const std::uint32_t key : keys) {
    const bool first = out.alternatives.empty();
    if (!first && (key >> 16U) > static_cast<std::uint32_t>(limit)) break;
    out.alternatives.push_back(displacement_of(key));
  }
  return out;
}

inline bool passes(const std::vector<Found>& found, const AgreementQuery& query) {
  std::vector<Displaced> tried;
  std::vector<const Found*> certain;
  std::vector<const Found*> doubtful;
  std::size_t extras = 0;
  for (const Found& of : found) {
    tried.insert(tried.end(), of.alternatives.begin(), of.alternatives.end());
    if (of.alternatives.empty()) continue;
    (of.alternatives.size() == 1 ? certain : doubtful).push_back(&of);
    if (of.alternatives.size() > alternatives_kept) return true;
    extras += of.alternatives.size() - 1;
  }
  if (extras > most_extras) return true;
  const auto support = [&](const Displaced& common) {
    std::vector<const Found*> agreeing;
    for (const Found* of : certain) {
      const Displaced& other = of->alternatives.front();
      const Displaced apart{other.column - common.column, other.row - common.row};
      if (squared_length(apart) <= query.largest_squared_spread) agreeing.push_back(of);
    }
    return agreeing;
  };
  std::size_t least = 0;
  for (const Found* of : certain) least = std::max(least, support(of->alternatives.front()).size());
  const int unit = query.cost_unit;
  const int most_each = query.squared ? static_cast<int>(2 * least) * unit : unit;
  return std::any_of(tried.begin(), tried.end(), [&](const Displaced& common) {
    const std::vector<const Found*> agreeing = support(common);
    const std::size_t count = agreeing.size() + doubtful.size();
    long long cost = 0;
    for (const Found* of : agreeing) cost += of->cost;
    for (const Found* of : doubtful) cost += std::min(of->cost, most_each);
    return count >= least && cost <= static_cast<long long>(query.squared ? count * count : count) * unit;
  });
}

inline std::uint32_t agreeing(const Batch& batch, const AgreementQuery& query) {
  std::uint32_t out = 0;
  for (std::size_t lane = 0; lane < batch.images; ++lane) {
    const BatchImage image{batch, lane};
    std::vector<Found> found;
    for (const AgreementRegion& region : query.regions) {
      const auto keys = sorted_keys(image, region, query.largest_squared_offset);
      found.push_back(found_of(keys, region.error, query.cost_of_step));
    }
    out |= static_cast<std::uint32_t>(passes(found, query)) << lane;
  }
  return out;
}

}  // namespace sailmap::index::plain
