#include "centre_surround.hpp"

#include <numeric>

#include "sailmap/hls/arithmetic.hpp"
#include "sailmap/hls/geometry.hpp"
#include "vectors.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "frontends/fixed/centre_surround.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "prefix_sum-inl.hpp"
#include "vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sailmap::fixed::HWY_NAMESPACE {
namespace {

constexpr int small_radius = hls::geometry::surround_radius_small;
constexpr int large_radius = hls::geometry::surround_radius_large;
static_assert(2 * large_radius + 2 == CentreSurround::rows);

constexpr int area(int radius) { return (2 * radius + 1) * (2 * radius + 1); }
// The contrasts have a common denominator.
constexpr int denominator = std::lcm(area(small_radius) - 1, area(large_radius) - 1);
constexpr int small_factor = denominator / (area(small_radius) - 1);
constexpr int large_factor = denominator / (area(large_radius) - 1);
// As hls::contrast_sum has it, of a lone centre and of a lone surround.
static_assert(small_factor * area(small_radius) + large_factor * area(large_radius) ==
                  hls::contrast_sum(1, 0, 0, 1) &&
              small_factor == hls::contrast_sum(0, 1, 0, -1) &&
              large_factor == hls::contrast_sum(0, 0, 1, -1));

// Row y of the table: above + the sums of the row from some column before the border up to each column. Sums
// wrap; differences of four of them, sums over windows, do not.
void add_row(const Sample* level, int width, const std::uint32_t* above, std::uint32_t* out) {
  const Words32 d;
  const Lanes32 d_signed;
  const HalfLanes16 d16;
  const PrefixSum prefix;
  auto before = hn::Zero(d);
  const int step = lanes_of(d);
  for (int x = -CentreSurround::rows; x < width + large_radius; x += step) {
    const auto samples = hn::BitCast(d, hn::PromoteTo(d_signed, hn::LoadU(d16, level + x)));
    const auto sums = hn::Add(prefix.of(samples), before);
    before = prefix.last_of(sums);
    hn::StoreU(hn::Add(sums, hn::LoadU(d, above + x)), d, out + x);
  }
}

// The sum over the window of radius Radius around each of the columns from x, given the rows of the table at
// its last row and before its first.
template <int Radius>
HWY_INLINE hn::Vec<Lanes32> window(const std::uint32_t* before, const std::uint32_t* last, int x) {
  const Words32 d;
  const auto right = hn::Sub(hn::LoadU(d, last + x + Radius), hn::LoadU(d, before + x + Radius));
  const auto left = hn::Sub(hn::LoadU(d, last + x - Radius - 1), hn::LoadU(d, before + x - Radius - 1));
  return hn::BitCast(Lanes32(), hn::Sub(right, left));
}

// 672 = 32 * 21: five fraction bits, and the 21 in the unit; hls::contrast says the same.
HWY_INLINE hn::Vec<Lanes32> contrast(hn::Vec<Lanes32> sum) {
  return requantise_lanes<hls::Exactly<27, formats::intensity::fraction + 5>, formats::intensity_contrast>(
      sum);
}

struct TableRows {
  const std::uint32_t* before_small;
  const std::uint32_t* last_small;
  const std::uint32_t* before_large;
  const std::uint32_t* last_large;
};

template <bool WithOff>
HWY_INLINE void contrasts(const Sample* level, int width, const TableRows& rows, std::int32_t* on,
                          std::int32_t* off) {
  const Lanes32 d;
  const HalfLanes16 d16;
  const auto zero = hn::Zero(d);
  const auto by_small = hn::Set(d, small_factor);
  const auto by_large = hn::Set(d, large_factor);
  for (int x = 0; x < width; x += lanes_of(d)) {
    const auto centre = hn::PromoteTo(d, hn::LoadU(d16, level + x));
    const auto small = hn::Sub(hn::Mul(centre, hn::Set(d, area(small_radius))),
                               window<small_radius>(rows.before_small, rows.last_small, x));
    const auto large = hn::Sub(hn::Mul(centre, hn::Set(d, area(large_radius))),
                               window<large_radius>(rows.before_large, rows.last_large, x));
    const auto on_sum =
        hn::Add(hn::Mul(hn::Max(small, zero), by_small), hn::Mul(hn::Max(large, zero), by_large));
    hn::StoreU(contrast(on_sum), d, on + x);
    if constexpr (WithOff) {
      // max(0, -v) = max(0, v) - v
      const auto sum = hn::Add(hn::Mul(small, by_small), hn::Mul(large, by_large));
      hn::StoreU(contrast(hn::Sub(on_sum, sum)), d, off + x);
    }
  }
}

void contrast_row(const Sample* level, int width, const TableRows& rows, std::int32_t* on,
                  std::int32_t* off) {
  if (off == nullptr) {
    contrasts<false>(level, width, rows, on, off);
  } else {
    contrasts<true>(level, width, rows, on, off);
  }
}

void centre_surround(const PaddedPlane<Sample>& level, PaddedPlane<std::uint32_t>& sums, ContrastPlane& on,
                     ContrastPlane* off) {
  const int width = level.width();
  const int height = level.height();
  const auto table = [&sums](int y) { return sums.row(y & (CentreSurround::rows - 1)); };
  std::uint32_t* const first = table(-large_radius - 1);
  std::fill(first - CentreSurround::rows, first + width + CentreSurround::rows, 0U);
  for (int y = -large_radius; y < height + large_radius; ++y) {
    add_row(level.clamped_row(y), width, table(y - 1), table(y));
    const int centre = y - large_radius;
    if (centre < 0) continue;
    contrast_row(level.row(centre), width,
                 {table(centre - small_radius - 1), table(centre + small_radius),
                  table(centre - large_radius - 1), table(centre + large_radius)},
                 on.row(centre), off == nullptr ? nullptr : off->row(centre));
  }
}

}  // namespace
}  // namespace sailmap::fixed::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sailmap::fixed {

HWY_EXPORT(centre_surround);

void CentreSurround::compute(const PaddedPlane<Sample>& level, ContrastPlane& on, ContrastPlane* off) {
  sums_.resize(level.width(), rows);
  on.resize(level.width(), level.height());
  if (off != nullptr) off->resize(level.width(), level.height());
  HWY_DYNAMIC_DISPATCH(centre_surround)(level, sums_, on, off);
}

}  // namespace sailmap::fixed
#endif
