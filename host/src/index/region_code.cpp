#include "region_code.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sailmap::index {
namespace {

// Where the closed levels of each direction begin and end: 2 % to 98 % of the regions of the sequences
// corridor and Gardens Point. Other images cost only speed.
struct Range {
  double first;
  double last;
};
constexpr std::array<Range, directions> ranges = {
    {{-0.68, 0.63}, {-0.49, 0.50}, {-0.49, 0.42}, {-0.49, 0.47}, {-0.26, 0.25}, {-0.24, 0.26}}};

double width_of_level(std::size_t direction) {
  return (ranges[direction].last - ranges[direction].first) / (levels - 2);
}

int level(double number, std::size_t direction) {
  const double steps = (number - ranges[direction].first) / width_of_level(direction);
  return static_cast<int>(std::clamp(std::floor(steps) + 1, 0.0, levels - 1.0));
}

std::uint8_t pack(int low, int high) { return static_cast<std::uint8_t>(low | (high << 4)); }

}  // namespace

Projection project(const Descriptor& descriptor) {
  std::array<double, feature_count> v{};
  for (std::size_t i = 0; i < feature_count; ++i) v[i] = std::clamp<double>(descriptor[i], -1000, 1000);
  const double root_half = std::sqrt(0.5);
  return {(v[0] - v[1]) * root_half,       (v[2] + v[3] - v[4] - v[5]) / 2, (v[2] - v[3] + v[4] - v[5]) / 2,
          (v[2] - v[3] - v[4] + v[5]) / 2, (v[6] + v[7] - v[8] - v[9]) / 2, (v[6] - v[7] - v[8] + v[9]) / 2};
}

int cell(int position, int side) {
  return std::clamp(position, 0, std::max(side, 1) - 1) * cells / std::max(side, 1);
}

RegionCode encode(const Region& region, int width, int height) {
  const Projection p = project(region.descriptor);
  RegionCode code{};
  for (std::size_t pair = 0; pair < directions / 2; ++pair) {
    code[pair] = pack(level(p[2 * pair], 2 * pair), level(p[2 * pair + 1], 2 * pair + 1));
  }
  code.back() = pack(cell(region.x, width), cell(region.y, height));
  return code;
}

double level_gap(double number, std::size_t direction, int level) {
  const double width = width_of_level(direction);
  const double begin = ranges[direction].first + width * (level - 1);
  const double below = level > 0 ? begin - number : 0;
  const double above = level < levels - 1 ? number - (begin + width) : 0;
  return std::max({0.0, below - projection_error, above - projection_error});
}

int cell_gap(int position, int cell, int side) {
  const int length = std::max(side, 1);
  const int first = (cell * length + cells - 1) / cells;  // the first pixel of the cell
  const int last = ((cell + 1) * length + cells - 1) / cells - 1;
  const int before = cell > 0 ? first - position : 0;
  const int after = cell < cells - 1 ? position - last : 0;
  return std::max({0, before, after});
}

bool can_be_bounded(const Signature& signature) {
  constexpr float largest = 1e14F;
  return std::all_of(signature.regions.begin(), signature.regions.end(), [](const Region& region) {
    return std::all_of(region.descriptor.begin(), region.descriptor.end(),
                       [](float v) { return std::abs(v) <= largest; });
  });
}

}  // namespace sailmap::index
