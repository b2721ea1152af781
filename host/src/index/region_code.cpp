#include "region_code.hpp"

#include <algorithm>
#include <cmath>

namespace sailmap::index {
namespace {

std::uint8_t code_of(double steps, int zero, int last) {
  return static_cast<std::uint8_t>(std::clamp(std::round(steps) + zero, 0.0, static_cast<double>(last)));
}

}  // namespace

Projection project(const Descriptor& descriptor) {
  std::array<double, feature_count> v{};
  for (std::size_t i = 0; i < feature_count; ++i) v[i] = std::clamp<double>(descriptor[i], -1000, 1000);
  return {(v[0] - v[1]) * std::sqrt(0.5),  (v[2] + v[3] - v[4] - v[5]) / 2, (v[2] - v[3] + v[4] - v[5]) / 2,
          (v[2] - v[3] - v[4] + v[5]) / 2, (v[6] + v[7] - v[8] - v[9]) / 2, (v[6] - v[7] - v[8] + v[9]) / 2};
}

PositionGrid::PositionGrid(int width, int height) {
  step = std::max(step, std::hypot(width, height) / (longest_diagonal - 3));
  const std::array<int, 2> sides = {std::max(width, 1), std::max(height, 1)};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    middle[axis] = sides[axis] / 8 * 4;
    zeros[axis] = static_cast<int>(std::ceil(middle[axis] / step));
  }
}

RegionCode encode(const Region& region, const PositionGrid& grid) {
  const Projection p = project(region.descriptor);
  RegionCode code{};
  for (std::size_t i = 0; i < directions; ++i) code[i] = code_of(p[i] / step, zero_code, last_code);
  const std::array<int, 2> position = {region.x, region.y};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const int zero = grid.zeros[axis];
    code[directions + axis] = code_of((position[axis] - grid.middle[axis]) / grid.step, zero, 2 * zero + 1);
  }
  return code;
}

bool is_exact(const Region& region, const PositionGrid& grid) {
  const RegionCode code = encode(region, grid);
  const std::array<int, 2> position = {region.x, region.y};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const int steps = code[directions + axis] - grid.zeros[axis];
    if (grid.middle[axis] + grid.step * steps != position[axis]) return false;
  }
  return true;
}

double code_error(const Descriptor& descriptor, const RegionCode& code) {
  const Projection p = project(descriptor);
  double sum = 0;
  for (std::size_t i = 0; i < directions; ++i) {
    const double steps = std::clamp(p[i] / step, double{-zero_code}, double{last_code - zero_code});
    const double error = steps - (code[i] - zero_code);
    sum += error * error;
  }
  return step * std::sqrt(sum);
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
