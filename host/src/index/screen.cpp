#include "screen.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "kernels.hpp"

namespace sailmap::index {
namespace {

// Bounds are rounded to their safe side by this part of themselves, far above what double precision loses.
constexpr double slack = 1e-6;
// What single precision can lose of a squared distance: a part for rounding, the rest for underflow.
constexpr double single_slack = 1e-5;
constexpr float single_underflow = 1e-37F;

// Constraint 1 fails for certain where the tables of column and row add up to this.
constexpr double too_far = 128;

std::uint8_t floor_to_byte(double value) { return static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0)); }

double search_radius(const Signature& query, const MatchConfig& config) {
  return config.search_radius * std::hypot(query.width, query.height);
}

std::array<std::uint8_t, levels> position_table(int position, int side, double radius) {
  std::array<std::uint8_t, levels> table{};
  for (int c = 0; c < cells; ++c) {
    const double gap = cell_gap(position, c, side);
    const double part = gap > 0 ? gap / radius : 0;
    table[static_cast<std::size_t>(c)] = floor_to_byte(too_far * part * part * (1 - slack));
  }
  table[no_cell] = 255;
  return table;
}

ScreenQuery::Columns reachable(const std::array<std::uint8_t, levels>& table) {
  ScreenQuery::Columns out{static_cast<std::uint8_t>(cells), 0};
  for (std::size_t c = 0; c < cells; ++c) {
    if (table[c] >= too_far) continue;
    out.first = std::min(out.first, static_cast<std::uint8_t>(c));
    out.last = static_cast<std::uint8_t>(c);
  }
  return out;
}

// The most S_k may be for k regions to reach the similarity.
double limit(std::size_t k, Method method, std::size_t regions, double similarity) {
  const auto matched = static_cast<double>(k);
  const double weight = method == Method::paper_weighted ? matched / static_cast<double>(regions) : 1;
  return weight * matched / similarity;
}

template <class Number>
void sort(Number* numbers, const std::vector<std::pair<std::uint16_t, std::uint16_t>>& network) {
  for (const auto& [i, j] : network) {
    const Number a = numbers[i];
    const Number b = numbers[j];
    numbers[i] = std::min(a, b);
    numbers[j] = std::max(a, b);
  }
}

}  // namespace

void Block::add(std::size_t lane, const Signature& signature) {
  const std::size_t count = signature.regions.size();
  std::vector<RegionCode> regions;
  regions.reserve(count);
  for (const Region& region : signature.regions) {
    regions.push_back(encode(region, signature.width, signature.height));
  }
  const auto column = [](const RegionCode& code) { return static_cast<std::uint8_t>(code.back() & 0x0F); };
  std::sort(regions.begin(), regions.end(),
            [&](const RegionCode& a, const RegionCode& b) { return column(a) < column(b); });
  if (count > slots()) {
    columns.reserve(count);
    columns.resize(count);
    codes.reserve(count * code_bytes * block_images);  // exactly: growth by doubling would waste memory
    codes.resize(count * code_bytes * block_images, no_cell);
  }
  for (std::size_t slot = 0; slot < count; ++slot) {
    for (std::size_t byte = 0; byte < code_bytes; ++byte) {
      codes[(slot * code_bytes + byte) * block_images + lane] = regions[slot][byte];
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

double similarity_bound(const float* rising, std::size_t count, Method method, std::size_t regions) {
  double sum = 0;
  double best = 0;
  for (std::size_t k = 0; k < count; ++k) {
    sum += static_cast<double>(rising[k]);
    best = std::max(best, limit(k + 1, method, regions, sum));
  }
  return best;
}

ScreenQuery::ScreenQuery(const Signature& query, const MatchConfig& config)
    : tables(query.regions.size()),
      columns(query.regions.size()),
      limits(query.regions.size()),
      network(sorting_network(query.regions.size())),
      method_(config.method) {
  const double radius = search_radius(query, config);
  for (std::size_t i = 0; i < query.regions.size(); ++i) {
    const Region& region = query.regions[i];
    projections_.push_back(project(region.descriptor));
    tables[i][directions] = position_table(region.x, query.width, radius);
    tables[i][directions + 1] = position_table(region.y, query.height, radius);
    columns[i] = reachable(tables[i][directions]);
  }
}

void ScreenQuery::set_scale(double clip) {
  clip_ = clip;
  const double units = 255 / (clip * clip) * (1 - slack);
  for (std::size_t i = 0; i < tables.size(); ++i) {
    for (std::size_t direction = 0; direction < directions; ++direction) {
      for (int level = 0; level < levels; ++level) {
        const double gap = level_gap(projections_[i][direction], direction, level);
        tables[i][direction][static_cast<std::size_t>(level)] = floor_to_byte(units * gap * gap);
      }
    }
  }
  for (std::size_t i = 0; i < 16; ++i) {
    const auto squared = static_cast<double>(i);
    roots[i] = floor_to_byte(std::sqrt(255 * squared));
    roots[16 + i] = floor_to_byte(std::sqrt(255 * 4 * squared));
    roots[32 + i] = floor_to_byte(std::sqrt(255 * 16 * squared));
  }
}

void ScreenQuery::set_threshold(double threshold) {
  // Beyond the clip all distances are one: it has to stay clear of what decides, which is below k / threshold
  // for one region (`paper`), around 1 / threshold for each of many (`paper_weighted`).
  const double wanted = std::clamp((method_ == Method::paper ? 1.1 : 2) / threshold, 1e-3, 4.0);
  if (clip_ == 0 || wanted < 0.85 * clip_) set_scale(wanted);
  for (std::size_t k = 1; k <= limits.size(); ++k) {
    const double most = limit(k, method_, tables.size(), threshold) * 255 / clip_ * (1 + slack);
    limits[k - 1] = static_cast<std::uint16_t>(std::min(most, 65535.0));
  }
}

std::uint64_t ScreenQuery::passing(const Block& block) {
  work.resize(std::max(work.size(), work_bytes(block.slots(), tables.size())));
  return screen_block(block, *this, work.data());
}

QueryLanes make_lanes(const Signature& query, const MatchConfig& config) {
  QueryLanes lanes;
  lanes.count = query.regions.size();
  const std::size_t padded = (lanes.count + lane_padding - 1) / lane_padding * lane_padding;
  constexpr float nowhere = 1e18F;
  lanes.x.assign(padded, nowhere);
  lanes.y.assign(padded, nowhere);
  lanes.descriptor.fill(std::vector<float>(padded));
  for (std::size_t i = 0; i < lanes.count; ++i) {
    const Region& region = query.regions[i];
    lanes.x[i] = region.x;
    lanes.y[i] = region.y;
    for (std::size_t k = 0; k < feature_count; ++k) lanes.descriptor[k][i] = region.descriptor[k];
  }
  const double radius = search_radius(query, config) * (1 + slack);
  lanes.squared_radius = static_cast<float>(std::min(radius * radius, 1e30));
  return lanes;
}

NearestBound::NearestBound(const Signature& query, const MatchConfig& config)
    : method_(config.method),
      lanes_(make_lanes(query, config)),
      network_(sorting_network(lanes_.count)),
      nearest_(lanes_.x.size()) {}

double NearestBound::operator()(const Signature& candidate) {
  nearest_squared(lanes_, candidate.regions.data(), candidate.regions.size(), nearest_.data());
  sort(nearest_.data(), network_);
  std::size_t count = 0;
  while (count < lanes_.count && nearest_[count] < 1e31F) {
    nearest_[count] = std::sqrt(std::max(0.0F, nearest_[count] - single_underflow));
    ++count;
  }
  const std::size_t regions = std::max(lanes_.count, candidate.regions.size());
  return similarity_bound(nearest_.data(), count, method_, regions) * (1 + single_slack);
}

}  // namespace sailmap::index
