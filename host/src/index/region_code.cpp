#include "region_code.hpp"

#include <algorithm>
#include <cmath>

namespace sailmap::index {
namespace {

std::uint8_t code_of(double steps) {
  return static_cast<std::uint8_t>(std::clamp(std::round(steps) + zero_code, 0.0, double{last_code}));
}

}  // namespace

Projection project(const Descriptor& descriptor) {
  std::array<double, feature_count> v{};
  for (std::size_t i = 0; i < feature_count; ++i) v[i] = std::clamp<double>(descriptor[i], -1000, 1000);
  return {(v[0] - v[1]) * std::sqrt(0.5),  (v[2] + v[3] - v[4] - v[5]) / 2, (v[2] - v[3] + v[4] - v[5]) / 2,
          (v[2] - v[3] - v[4] + v[5]) / 2, (v[6] + v[7] - v[8] - v[9]) / 2, (v[6] - v[7] - v[8] + v[9]) / 2};
}

double position_step(int width, int height) { return std::max({width, height, 1}) / 126.0; }

RegionCode encode(const Region& region, int width, int height) {
  const Projection p = project(region.descriptor);
  RegionCode code{};
  for (std::size_t i = 0; i < directions; ++i) code[i] = code_of(p[i] / step);
  const double pixels = position_step(width, height);
  code[directions] = code_of((region.x - width / 2.0) / pixels);
  code[directions + 1] = code_of((region.y - height / 2.0) / pixels);
  return code;
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
  return std::all_of(signature.regions.begin(), signature.regions.end(), [](const Region& region) {
    return std::all_of(region.descriptor.begin(), region.descriptor.end(),
                       [](float v) { return std::abs(v) <= largest; });
  });
}

}  // namespace sailmap::index
