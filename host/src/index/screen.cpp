#include "screen.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "kernels.hpp"

namespace sailmap::index {
namespace {

// Bounds are rounded to their safe side by this part of themselves, far above what double precision loses.
constexpr double slack = 1e-6;
double search_radius(const Signature& query, const MatchConfig& config) {
  return config.search_radius * std::hypot(query.width, query.height);
}

// -q in two signed bytes.
std::int16_t minus_pair(int first, int second) {
  const auto low = static_cast<std::uint8_t>(zero_code - first);
  const auto high = static_cast<std::uint8_t>(zero_code - second);
  return static_cast<std::int16_t>(low | (high << 8));
}

// |q|^2 / 2, rounded down, and the sum of q, of the codes [begin, end).
struct Moments {
  int half_square = 0;
  int sum = 0;
};
Moments moments(const RegionCode& code, std::size_t begin, std::size_t end) {
  Moments out;
  for (std::size_t i = begin; i < end; ++i) {
    const int q = code[i] - zero_code;
    out.half_square += q * q;
    out.sum += q;
  }
  out.half_square /= 2;
  return out;
}

// `radius` in steps of position codes, both of which may be off by half in each direction.
ScreenRegion screen_region(const RegionCode& code, double radius) {
  ScreenRegion out;
  for (std::size_t i = 0; i < code_bytes / 2; ++i) {
    out.minus_pairs[i] = minus_pair(code[2 * i], code[2 * i + 1]);
  }
  const Moments descriptor = moments(code, 0, directions);
  out.descriptor_rest = static_cast<std::int16_t>(descriptor.half_square + zero_code * descriptor.sum);
  const Moments position = moments(code, directions, code_bytes);
  constexpr double all = last_code * last_code;  // half the squared diagonal of the codes
  const double reach = radius + std::sqrt(2.0) + slack;
  const int limit = static_cast<int>(std::min(reach * reach / 2, all));
  out.position_limit = static_cast<std::int16_t>(limit + 1 - position.half_square - zero_code * position.sum);
  const double column = code[directions];
  const double columns = std::min(radius + 1 + slack, 2.0 * last_code);
  out.first_column = static_cast<std::uint8_t>(std::max(0.0, std::ceil(column - columns)));
  out.last_column = static_cast<std::uint8_t>(std::min(double{last_code}, column + columns));
  return out;
}

// The most S_k may be for k regions to reach the similarity.
double limit(std::size_t k, Method method, std::size_t regions, double similarity) {
  const auto matched = static_cast<double>(k);
  const double weight = method == Method::paper_weighted ? matched / static_cast<double>(regions) : 1;
  return weight * matched / similarity;
}

}  // namespace

void Block::add(std::size_t lane, const Signature& signature) {
  const std::size_t count = signature.regions.size();
  std::vector<RegionCode> regions;
  regions.reserve(count);
  for (const Region& region : signature.regions) {
    regions.push_back(encode(region, signature.width, signature.height));
  }
  const auto column = [](const RegionCode& code) { return code[directions]; };
  std::sort(regions.begin(), regions.end(),
            [&](const RegionCode& a, const RegionCode& b) { return column(a) < column(b); });
  if (count > slots()) {
    columns.reserve(count);
    columns.resize(count);
    codes.reserve(count * slot_bytes);  // exactly: growth by doubling would waste memory
    codes.resize(count * slot_bytes, zero_code);
  }
  counts[lane] = static_cast<std::int16_t>(std::min<std::size_t>(count, INT16_MAX));
  for (std::size_t slot = 0; slot < count; ++slot) {
    for (std::size_t byte = 0; byte < code_bytes; ++byte) {
      const std::size_t row = slot * slot_bytes + byte / 2 * row_bytes;
      codes[row + 2 * lane + byte % 2] = regions[slot][byte];
    }
    columns[slot].first = std::min(columns[slot].first, column(regions[slot]));
    columns[slot].last = std::max(columns[slot].last, column(regions[slot]));
  }
}

std::size_t Block::memory() const { return codes.capacity() + columns.capacity() * sizeof(Columns); }

std::vector<std::pair<std::uint16_t, std::uint16_t>> sorting_network(std::size_t size) {
  std::vector<std::pair<std::uint16_t, std::uint16_t>> network;
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
    : limits(query.regions.size()), network(sorting_network(query.regions.size())), method_(config.method) {
  const double radius = search_radius(query, config) / position_step(query.width, query.height);
  std::vector<const Region*> order;
  for (const Region& region : query.regions) order.push_back(&region);
  std::sort(order.begin(), order.end(), [](const Region* a, const Region* b) { return a->x < b->x; });
  for (const Region* region : order) {
    const RegionCode code = encode(*region, query.width, query.height);
    regions.push_back(screen_region(code, radius));
    errors_.push_back(largest_code_error + code_error(region->descriptor, code) + slack);
  }
}

void ScreenQuery::set_threshold(double threshold) {
  // Beyond the clip all distances are one: it has to stay clear of what decides, which is below k / threshold
  // for one region (`paper`), around 1 / threshold for each of many (`paper_weighted`).
  const double clip = std::clamp((method_ == Method::paper ? 1.1 : 2) / threshold, 1e-3, 4.0);
  const double codes = 255 / clip;
  scale = static_cast<float>(step * codes * (1 - slack));
  for (std::size_t i = 0; i < regions.size(); ++i) {
    regions[i].error = static_cast<float>(errors_[i] * codes * (1 + slack));
  }
  for (std::size_t k = 1; k <= limits.size(); ++k) {
    const double most = limit(k, method_, regions.size(), threshold) * codes * (1 + slack);
    limits[k - 1] = static_cast<std::uint16_t>(std::min(most, 65535.0));
  }
}

std::uint64_t ScreenQuery::passing(const Block& block) {
  work_.resize(std::max(work_.size(), work_bytes(block.slots(), regions.size())));
  return screen_block(block, *this, work_.data());
}

}  // namespace sailmap::index
