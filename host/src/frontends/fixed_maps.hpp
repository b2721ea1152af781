// What the fixed-point front ends share: raw integers and their format become a Map.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "sailmap/hls/formats.hpp"
#include "sailmap/maps.hpp"

namespace sailmap {

// What one unit of a raw integer of format F is worth, in the spec's units.
template <class F>
constexpr double lsb_of() {
  double lsb = F::unit();
  for (int i = 0; i < F::fraction; ++i) lsb /= 2;
  for (int i = 0; i > F::fraction; --i) lsb *= 2;
  return lsb;
}

// Calls `use(format, index)` for each feature map in the order of spec section 6, with a value of its format.
template <class Use>
void for_each_feature_format(Use use) {
  using namespace hls::geometry;
  std::size_t index = 0;
  for (int i = 0; i < intensity_maps; ++i) use(hls::formats::intensity_feature{}, index++);
  for (int i = 0; i < colour_maps; ++i) use(hls::formats::colour_feature{}, index++);
  for (int i = 0; i < orientation_maps; ++i) use(hls::formats::orientation_feature{}, index++);
}

// The same for the conspicuity maps.
template <class Use>
void for_each_conspicuity_format(Use use) {
  use(hls::formats::intensity_conspicuity{}, std::size_t{0});
  use(hls::formats::colour_conspicuity{}, std::size_t{1});
  use(hls::formats::orientation_conspicuity{}, std::size_t{2});
}

// The samples of `map` as raw integers of F, `width` x `height`, for the front end to fill; those of a frame
// of the same size are still there.
template <class F>
Plane<typename F::native>& raw_samples(Map& map, int width, int height) {
  using Raw = Plane<typename F::native>;
  if (!std::holds_alternative<Raw>(map.samples)) map.samples = Raw();
  map.lsb = lsb_of<F>();
  map.format = F::name();
  Raw& samples = std::get<Raw>(map.samples);
  if (samples.width() != width || samples.height() != height) samples.reset(width, height);
  return samples;
}

// `maximum` raw, `maxima` a count: what the hardware says of a map of format F.
template <class F>
MapStatistics statistics_of_raw(std::uint32_t maximum, std::uint32_t maxima) {
  return {maximum * lsb_of<F>(), static_cast<int>(maxima)};
}

}  // namespace sailmap
