#include "screen.hpp"

#include <algorithm>
#include <cmath>

#include "kernels.hpp"

namespace sailmap::index {
namespace {

// Bounds are rounded to their safe side by this part of themselves, far above what double precision loses.
constexpr double slack = 1e-6;

// Two unsigned bytes in one number.
std::int16_t pair_of(int first, int second) { return static_cast<std::int16_t>(first | (second << 8)); }

// `radius` and `error` in steps of position codes.
std::int16_t position_limit(double radius, double error, int half_square) {
  constexpr double all = 65536;  // beyond half of any squared offset
  const double reach = radius + error + slack;
  const int limit = static_cast<int>(std::min(reach * reach / 2, all)) + 1 - half_square - position_bias;
  return static_cast<std::int16_t>(std::min<int>(limit, INT16_MAX));
}

void set_descriptor(const QueryCode& code, ScreenRegion& region) {
  int square = 0;
  for (const int half_steps : code) square += half_steps * half_steps;
  for (std::size_t i = 0; i < direction_rows; ++i) {
    const int second = 2 * i + 1 < directions ? code[2 * i + 1] : 0;
    region.pairs[i] = pair_of(code[2 * i] + direction_origin, second + direction_origin);
  }
  region.descriptor_rest = static_cast<std::int16_t>(square / 4);
}

// `radius` in pixels.
void set_position(const RegionCode& code, const PositionGrid& grid, double radius, ScreenRegion& out) {
  const int x = code[column_byte];
  const int y = code[row_byte];
  const int column = x + position_zero;
  const int half_square = (x * x + y * y) / 2;
  out.pairs[direction_rows] = pair_of(column, y + position_zero);
  const double off = std::sqrt(2.0);  // both codes, by half in each direction
  const double reach = radius / grid.step;
  out.position_limits = {position_limit(reach, 0, half_square), position_limit(reach, off, half_square)};
  const double columns = std::min(reach + off, 255.0);
  out.first_column = static_cast<std::uint8_t>(std::max(0.0, std::floor(column - columns)));
  out.last_column = static_cast<std::uint8_t>(std::min(255.0, std::ceil(column + columns)));
}

}  // namespace

ScreenRegion screen_region(const Region& region, const PositionGrid& grid, double radius) {
  ScreenRegion out;
  set_descriptor(encode_query(region.descriptor), out);
  set_position(encode(region, grid), grid, radius, out);
  return out;
}

std::vector<const Region*> by_column(const Signature& signature) {
  std::vector<const Region*> order;
  order.reserve(signature.regions.size());
  for (const Region& region : signature.regions) order.push_back(&region);
  std::sort(order.begin(), order.end(), [](const Region* a, const Region* b) { return a->x < b->x; });
  return order;
}

void Block::add(std::size_t lane, const Signature& signature) {
  const PositionGrid grid(signature.width, signature.height);
  const std::size_t count = signature.regions.size();
  std::vector<RegionCode> regions;
  regions.reserve(count);
  bool exact = true;
  for (const Region& region : signature.regions) {
    regions.push_back(encode(region, grid));
    exact = exact && is_exact(region, grid);
  }
  exact_positions = exact_positions && exact;
  const auto column = [](const RegionCode& code) { return code[column_byte]; };
  std::sort(regions.begin(), regions.end(),
            [&](const RegionCode& a, const RegionCode& b) { return column(a) < column(b); });
  if (count > slots()) {
    codes.reserve(count * slot_bytes);  // exactly: growth by doubling would waste memory
    codes.resize(count * slot_bytes);
  }
  counts[lane] = static_cast<std::int16_t>(count);
  kinds[lane] = exact ? kinds_shared(signature) : no_shares;
  for (std::size_t slot = 0; slot < count; ++slot) {
    for (std::size_t byte = 0; byte < code_bytes; ++byte) {
      const std::size_t row = slot * slot_bytes + byte / 2 * row_bytes;
      codes[row + 2 * lane + byte % 2] = static_cast<std::uint8_t>(regions[slot][byte]);
    }
    columns[lane / group_images].add(slot, column(regions[slot]));
  }
}

std::size_t Block::memory() const { return codes.capacity(); }

SortingNetwork sorting_network(std::size_t size) {
  SortingNetwork network;
  for (std::size_t p = 1; p < size; p *= 2) {
    for (std::size_t k = p; k >= 1; k /= 2) {
      for (std::size_t j = k % p; j + k < size; j += 2 * k) {
        for (std::size_t i = 0; i < std::min(k, size - j - k); ++i) {
          if ((i + j) / (p * 2) != (i + j + k) / (p * 2)) continue;
          network.emplace_back(static_cast<std::uint16_t>(i + j), static_cast<std::uint16_t>(i + j + k));
        }
      }
    }
  }
  return network;
}

ScreenQuery::ScreenQuery(const Signature& query, const MatchConfig& config)
    : one_is_enough(config.method == Method::paper),
      limits(query.regions.size()),
      network(sorting_network(query.regions.size())) {
  const double radius = config.search_radius * std::hypot(query.width, query.height);
  const PositionGrid grid(query.width, query.height);
  for (const Region* region : by_column(query)) {
    regions.push_back(screen_region(*region, grid, radius));
    exact_positions = exact_positions && is_exact(*region, grid);
    errors_.push_back(both_code_errors(*region));
  }
}

void ScreenQuery::set_threshold(double threshold) {
  if (one_is_enough) {
    set_squared_limits(threshold);
  } else {
    set_limits(threshold);
  }
}

void ScreenQuery::set_squared_limits(double threshold) {
  constexpr double most = no_distance;  // when nothing is known to be too far, not even what is not there
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const double reach = (1 / threshold + errors_[i]) / step;
    regions[i].squared_limit = static_cast<std::uint16_t>(std::min(reach * reach * (1 + slack), most));
  }
}

void ScreenQuery::set_limits(double threshold) {
  // Beyond the clip all distances are one: it has to stay clear of what decides, which is around 1 /
  // threshold for each of many regions.
  const double clip = std::clamp(2 / threshold, 1e-3, 4.0);
  const double codes = 255 / clip;
  scale = static_cast<float>(step * codes * (1 - slack));
  for (std::size_t i = 0; i < regions.size(); ++i) {
    regions[i].error = static_cast<float>(errors_[i] * codes * (1 + slack));
  }
  for (std::size_t k = 1; k <= limits.size(); ++k) {
    const auto square = static_cast<double>(k * k);
    const double most = square / static_cast<double>(limits.size()) / threshold * codes * (1 + slack);
    limits[k - 1] = static_cast<std::uint16_t>(std::min(most, 65535.0));
  }
}

std::uint64_t ScreenQuery::passing(const Block& block, const Block& next) {
  work_.resize(std::max(work_.size(), work_bytes(block.slots(), regions.size())));
  return screen_block(block, next, *this, work_.data());
}

}  // namespace sailmap::index
