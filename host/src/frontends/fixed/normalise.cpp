#include "normalise.hpp"

#include "vectors.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "frontends/fixed/normalise.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sailmap::fixed::HWY_NAMESPACE {
namespace {

namespace formats = hls::formats;
using Stored = hn::Rebind<std::uint16_t, Lanes32>;

// hls::normalise of vectors. The product fits 32 bits, and since the result is below 2^20, what it is shifted
// left by as well.
class Normalised {
 public:
  explicit Normalised(const GainedMap& map)
      : samples_(map.samples),
        mantissa_(hn::Set(Words32(), map.gain.mantissa)),
        left_(std::max(finer - map.gain.shift, 0)),
        right_(std::max(map.gain.shift - finer, 0)) {}

  HWY_INLINE hn::Vec<Words32> at(std::ptrdiff_t i) const {
    const auto product = hn::Mul(hn::PromoteTo(Words32(), hn::LoadU(Stored(), samples_ + i)), mantissa_);
    return hn::ShiftRightSame(hn::ShiftLeftSame(product, left_), right_);
  }

 private:
  static constexpr int finer = formats::normalised::fraction - formats::gain::fraction;
  const std::uint16_t* samples_;
  hn::Vec<Words32> mantissa_;
  int left_;
  int right_;
};

template <int Count>
struct NormalisedMaps {
  Normalised own;
  NormalisedMaps<Count - 1> rest;

  explicit NormalisedMaps(const GainedMap* maps) : own(*maps), rest(maps + 1) {}
  HWY_INLINE hn::Vec<Words32> sum(std::ptrdiff_t i) const { return hn::Add(own.at(i), rest.sum(i)); }
};
template <>
struct NormalisedMaps<1> {
  Normalised own;

  explicit NormalisedMaps(const GainedMap* maps) : own(*maps) {}
  HWY_INLINE hn::Vec<Words32> sum(std::ptrdiff_t i) const { return own.at(i); }
};

template <class From, class To>
HWY_INLINE void store(hn::Vec<Lanes32> sum, std::uint16_t* to) {
  static_assert(To::word == 16, "the cut to 16 bits cuts nothing");
  hn::StoreU(hn::DemoteTo(Stored(), requantise_lanes<From, To>(sum)), Stored(), to);
}

// The last vector of a row ends with it and may overlap the one before.
template <int Count, class Sum, class To>
HWY_INLINE std::int32_t conspicuity(const GainedMap* maps, SumPlane& sums, std::uint16_t* stored) {
  const Lanes32 d;
  const int step = lanes_of(d);
  const int width = sums.width();
  const NormalisedMaps<Count> normalised(maps);
  auto most = hn::Zero(d);
  for (int y = 0; y < sums.height(); ++y) {
    const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(y) * width;
    std::int32_t* row = sums.row(y);
    for (int from = 0; from < width; from += step) {
      const int x = std::min(from, width - step);
      const auto sum = hn::BitCast(d, normalised.sum(first + x));
      hn::StoreU(sum, d, row + x);
      store<Sum, To>(sum, stored + first + x);
      most = hn::Max(most, sum);
    }
  }
  return hn::GetLane(hn::MaxOfLanes(d, most));
}

std::int32_t of_intensity(const GainedMap* maps, SumPlane& sums, std::uint16_t* stored) {
  return conspicuity<hls::geometry::intensity_maps, formats::intensity_conspicuity_sum,
                     formats::intensity_conspicuity>(maps, sums, stored);
}
std::int32_t of_colour(const GainedMap* maps, SumPlane& sums, std::uint16_t* stored) {
  return conspicuity<hls::geometry::colour_maps, formats::colour_conspicuity_sum,
                     formats::colour_conspicuity>(maps, sums, stored);
}
std::int32_t of_orientation(const GainedMap* maps, SumPlane& sums, std::uint16_t* stored) {
  return conspicuity<hls::geometry::orientation_maps, formats::orientation_conspicuity_sum,
                     formats::orientation_conspicuity>(maps, sums, stored);
}

void of_conspicuities(const GainedMap* maps, std::ptrdiff_t pixels, std::uint16_t* stored) {
  using Sum = hls::Exactly<22, formats::normalised_conspicuity::fraction>;
  const int step = lanes_of(Lanes32());
  const NormalisedMaps<hls::geometry::conspicuity_maps> normalised(maps);
  for (std::ptrdiff_t from = 0; from < pixels; from += step) {
    const std::ptrdiff_t i = std::min(from, pixels - step);
    store<Sum, formats::saliency>(hn::BitCast(Lanes32(), normalised.sum(i)), stored + i);
  }
}

}  // namespace
}  // namespace sailmap::fixed::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sailmap::fixed {

HWY_EXPORT(of_intensity);
HWY_EXPORT(of_colour);
HWY_EXPORT(of_orientation);
HWY_EXPORT(of_conspicuities);

std::int32_t intensity_conspicuity(std::span<const GainedMap> maps, SumPlane& sums, std::uint16_t* stored) {
  return HWY_DYNAMIC_DISPATCH(of_intensity)(maps.data(), sums, stored);
}

std::int32_t colour_conspicuity(std::span<const GainedMap> maps, SumPlane& sums, std::uint16_t* stored) {
  return HWY_DYNAMIC_DISPATCH(of_colour)(maps.data(), sums, stored);
}

std::int32_t orientation_conspicuity(std::span<const GainedMap> maps, SumPlane& sums, std::uint16_t* stored) {
  return HWY_DYNAMIC_DISPATCH(of_orientation)(maps.data(), sums, stored);
}

void saliency(std::span<const GainedMap> maps, int width, int height, std::uint16_t* stored) {
  HWY_DYNAMIC_DISPATCH(of_conspicuities)
  (maps.data(), static_cast<std::ptrdiff_t>(width) * height, stored);
}

}  // namespace sailmap::fixed
#endif
