#include "across_scales.hpp"

#include "sailmap/hls/arithmetic.hpp"
#include "sailmap/hls/ranges.hpp"
#include "vectors.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "frontends/fixed/across_scales.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sailmap::fixed::HWY_NAMESPACE {
namespace {

namespace formats = hls::formats;
using Level = formats::intensity_contrast;
using Partial = formats::intensity_partial;
using Sum = formats::intensity_sum;
using Feature = formats::intensity_feature;
// hls/arithmetic.hpp proves that one set of formats stands for all three kinds.

// Interpolation adds four neighbours and divides by four, which is left to the point of the sum.
constexpr int interpolation_bits = 2;
static_assert(Sum::fraction == Partial::fraction + interpolation_bits, "the sum is exact");

// Row y of the finer level: the sum of the four neighbours of each pixel; even ones lie on one.
HWY_INLINE void interpolate(PaddedPlane<std::int32_t>& coarse, int y, std::int32_t* out) {
  const Lanes32 d;
  const std::int32_t* upper = coarse.clamped_row(y / 2);
  const std::int32_t* lower = coarse.clamped_row(y / 2 + y % 2);
  for (int x = 0; x < coarse.width(); x += lanes_of(d)) {
    const auto here = hn::Add(hn::LoadU(d, upper + x), hn::LoadU(d, lower + x));
    const auto next = hn::Add(hn::LoadU(d, upper + x + 1), hn::LoadU(d, lower + x + 1));
    hn::StoreInterleaved2(hn::Add(here, here), hn::Add(here, next), d,
                          out + 2 * static_cast<std::ptrdiff_t>(x));
  }
}

void replicate_last_column(PaddedPlane<std::int32_t>& plane) {
  for (int y = 0; y < plane.height(); ++y) plane.row(y)[plane.width()] = plane.row(y)[plane.width() - 1];
}

// hls::partial_sum, in place of the finer level.
HWY_INLINE void partial_sums(const std::int32_t* coarse, int width, std::int32_t* finer) {
  const Lanes32 d;
  for (int x = 0; x < width; x += lanes_of(d)) {
    const auto sum =
        hn::Add(hn::LoadU(d, coarse + x), hn::ShiftLeft<interpolation_bits>(hn::LoadU(d, finer + x)));
    hn::StoreU(requantise_lanes<hls::Exactly<21, Level::fraction + interpolation_bits>, Partial>(sum), d,
               finer + x);
  }
}

// hls::level_sum and hls::feature. The last vector ends with the row and may overlap the one before.
HWY_INLINE hn::Vec<Lanes32> sums_of_row(const std::int32_t* coarse, const std::int32_t* finer, int width,
                                        std::int32_t* sums, std::uint16_t* feature, hn::Vec<Lanes32> most) {
  const Lanes32 d;
  const hn::Rebind<std::uint16_t, Lanes32> d16;
  static_assert(hls::ranges::max_of(hls::ranges::intensity_feature, hls::ranges::colour_feature) <= 0xffff &&
                hls::ranges::orientation_feature <= 0xffff);
  const int step = lanes_of(d);
  for (int from = 0; from < width; from += step) {
    const int x = std::min(from, width - step);
    const auto sum = hn::Add(hn::LoadU(d, coarse + x),
                             hn::ShiftLeft<Sum::fraction - Level::fraction>(hn::LoadU(d, finer + x)));
    hn::StoreU(sum, d, sums + x);
    hn::StoreU(hn::DemoteTo(d16, requantise_lanes<Sum, Feature>(sum)), d16, feature + x);
    most = hn::Max(most, sum);
  }
  return most;
}

std::int32_t across_scales(std::array<PaddedPlane<std::int32_t>, hls::geometry::map_levels>& levels,
                           std::int32_t* interpolated, SumPlane& sums, std::uint16_t* feature) {
  const Lanes32 d;
  static_assert(hls::geometry::map_levels == 3, "one partial sum, then the sum of all");
  auto& [base, middle, top] = levels;
  replicate_last_column(top);
  for (int y = 0; y < middle.height(); ++y) {
    interpolate(top, y, interpolated);
    partial_sums(interpolated, middle.width(), middle.row(y));
  }
  replicate_last_column(middle);
  auto most = hn::Zero(d);
  const int width = base.width();
  for (int y = 0; y < base.height(); ++y) {
    interpolate(middle, y, interpolated);
    most = sums_of_row(interpolated, base.row(y), width, sums.row(y),
                       feature + static_cast<std::ptrdiff_t>(y) * width, most);
  }
  return hn::GetLane(hn::MaxOfLanes(d, most));
}

}  // namespace
}  // namespace sailmap::fixed::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sailmap::fixed {

HWY_EXPORT(across_scales);

std::int32_t AcrossScales::compute(std::array<PaddedPlane<std::int32_t>, hls::geometry::map_levels>& levels,
                                   SumPlane& sums, std::uint16_t* feature) {
  const auto& base = levels.front();
  row_.resize(base.width(), 1);
  sums.resize(base.width(), base.height());
  return HWY_DYNAMIC_DISPATCH(across_scales)(levels, row_.row(0), sums, feature);
}

}  // namespace sailmap::fixed
#endif
