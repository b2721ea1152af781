#include "region_code.hpp"

#include <algorithm>
#include <cmath>

namespace sailmap::index {
namespace {

std::int8_t code_of(double steps, int first, int last) {
  return static_cast<std::int8_t>(
      std::clamp(std::round(steps), static_cast<double>(first), static_cast<double>(last)));
}

// In steps from 0, cut to what codes hold: what the errors are against.
Projection cut_steps(const Descriptor& descriptor) {
  Projection p = project(descriptor);
  for (double& number : p) {
    number = std::clamp(number / step, double{first_code}, double{last_code});
  }
  return p;
}

// See the grid's zero. `codes` columns or rows.
double largest_product(double codes) { return std::max(0.0, codes - position_zero) * codes; }

}  // namespace

Projection project(const Descriptor& descriptor) {
  std::array<double, feature_count> v{};
  for (std::size_t i = 0; i < feature_count; ++i) v[i] = std::clamp<double>(descriptor[i], -1000, 1000);
  return {(v[0] - v[1]) * std::sqrt(0.5),  (v[2] + v[3] - v[4] - v[5]) / 2, (v[2] - v[3] + v[4] - v[5]) / 2,
          (v[2] - v[3] - v[4] + v[5]) / 2, (v[6] + v[7] - v[8] - v[9]) / 2, (v[6] - v[7] - v[8] + v[9]) / 2,
          (v[6] - v[7] + v[8] - v[9]) / 2};
}

PositionGrid::PositionGrid(int width, int height) {
  constexpr double last_byte = 2 * position_zero;
  constexpr double longest_side = 32767;  // positions have 16 bits
  const std::array<double, 2> sides = {std::clamp<double>(width, 1, longest_side),
                                       std::clamp<double>(height, 1, longest_side)};
  const auto fits = [&] {
    const double columns = std::ceil(sides[0] / step);
    const double rows = std::ceil(sides[1] / step);
    return std::max(columns, rows) <= last_byte &&
           largest_product(columns) + largest_product(rows) <= INT16_MAX;
  };
  while (!fits()) step *= 1.02;
  for (std::size_t axis = 0; axis < 2; ++axis) last[axis] = static_cast<int>(std::ceil(sides[axis] / step));
}

RegionCode encode(const Region& region, const PositionGrid& grid) {
  const Projection p = project(region.descriptor);
  RegionCode code{};
  for (std::size_t i = 0; i < directions; ++i) code[i] = code_of(p[i] / step, first_code, last_code);
  const std::array<int, 2> position = {region.x, region.y};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    code[column_byte + axis] = code_of(std::round(position[axis] / grid.step) - position_zero, -position_zero,
                                       grid.last[axis] - position_zero);
  }
  return code;
}

bool is_exact(const Region& region, const PositionGrid& grid) {
  const RegionCode code = encode(region, grid);
  const std::array<int, 2> position = {region.x, region.y};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (grid.step * (position_zero + code[column_byte + axis]) != position[axis]) return false;
  }
  return true;
}

double code_error(const Descriptor& descriptor, const RegionCode& code) {
  const Projection steps = cut_steps(descriptor);
  double sum = 0;
  for (std::size_t i = 0; i < directions; ++i) {
    const double error = steps[i] - code[i];
    sum += error * error;
  }
  return step * std::sqrt(sum);
}

QueryCode encode_query(const Descriptor& descriptor) {
  const Projection steps = cut_steps(descriptor);
  QueryCode code{};
  for (std::size_t i = 0; i < directions; ++i) {
    code[i] = std::clamp(static_cast<int>(std::lround(2 * steps[i])), -last_half_step, last_half_step);
  }
  return code;
}

double code_error(const Descriptor& descriptor, const QueryCode& code) {
  const Projection steps = cut_steps(descriptor);
  double sum = 0;
  for (std::size_t i = 0; i < directions; ++i) {
    const double error = steps[i] - code[i] / 2.0;
    sum += error * error;
  }
  return step * std::sqrt(sum);
}

double both_code_errors(const Region& query) {
  constexpr double slack = 1e-6;  // far above what double precision loses
  return largest_code_error + code_error(query.descriptor, encode_query(query.descriptor)) + slack;
}

std::uint8_t kinds_shared(const Signature& signature) {
  std::uint8_t of_all = no_shares;
  for (const Region& region : signature.regions) {
    std::array<double, conspicuity_count> sums{};
    for (std::size_t i = 0; i < feature_count; ++i) {
      if (!(region.descriptor[i] >= 0)) return no_shares;
      sums[kind_of_feature[i]] += region.descriptor[i];
    }
    std::uint8_t kinds = 0;
    for (std::size_t kind = 0; kind < conspicuity_count; ++kind) {
      const bool shared = std::abs(sums[kind] - 1) <= share_error;
      if (!shared && !(sums[kind] <= share_error)) return no_shares;
      kinds = static_cast<std::uint8_t>(kinds | (shared ? 1U << kind : 0U));
    }
    if (of_all != no_shares && of_all != kinds) return no_shares;
    for (const double number : project(region.descriptor)) {
      if (std::abs(number) > step * last_code) return no_shares;
    }
    of_all = kinds;
  }
  return of_all;
}

bool can_be_bounded(const Signature& signature) {
  constexpr float largest = 1e14F;
  constexpr std::size_t most_regions = 1000;  // their numbers fit in 16 bits
  if (signature.regions.size() > most_regions) return false;
  return std::all_of(signature.regions.begin(), signature.regions.end(), [](const Region& region) {
    return std::all_of(region.descriptor.begin(), region.descriptor.end(),
                       [](float v) { return std::abs(v) <= largest; });
  });
}

}  // namespace sailmap::index
