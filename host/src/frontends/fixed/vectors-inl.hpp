// What the kernels of all stages need of vectors; compiled once for each target (hence no #pragma once).
#if defined(SAILMAP_FIXED_VECTORS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SAILMAP_FIXED_VECTORS_INL
#undef SAILMAP_FIXED_VECTORS_INL
#else
#define SAILMAP_FIXED_VECTORS_INL
#endif

#include <hwy/highway.h>

#include "sailmap/hls/requantise.hpp"

HWY_BEFORE_NAMESPACE();
namespace sailmap::fixed::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// At most 512 bits: no image is narrower than such a vector.
using Lanes16 = hn::CappedTag<std::int16_t, 32>;
using Lanes32 = hn::CappedTag<std::int32_t, 16>;
using Words32 = hn::CappedTag<std::uint32_t, 16>;
using HalfLanes16 = hn::Rebind<std::int16_t, Lanes32>;

template <class D>
int lanes_of(D d) {
  return static_cast<int>(hn::Lanes(d));
}

// hls::requantise of every lane, for values whose result fits To.
template <class From, class To, class V>
HWY_INLINE V requantise_lanes(V v) {
  static_assert(To::rounding == hls::Rounding::rnd || To::rounding == hls::Rounding::trn);
  constexpr int shift = From::fraction - To::fraction;
  static_assert(shift > 0);
  if constexpr (To::rounding == hls::Rounding::rnd) {
    v = hn::Add(v, hn::Set(hn::DFromV<V>(), hn::TFromV<V>{1} << (shift - 1)));
  }
  return hn::ShiftRight<shift>(v);
}

// The weights of even and of odd lanes, for sum_of_pairs.
HWY_INLINE hn::Vec<Lanes16> pair_of_weights(int even, int odd) {
  const Lanes16 d;
  return hn::OddEven(hn::Set(d, static_cast<std::int16_t>(odd)), hn::Set(d, static_cast<std::int16_t>(even)));
}

// Lane i: the sum over k of samples[k][2i] weights[k][2i] + samples[k][2i+1] weights[k][2i+1].
template <std::size_t Count>
HWY_INLINE hn::Vec<Lanes32> sum_of_pairs(const hn::Vec<Lanes16> (&samples)[Count],
                                         const hn::Vec<Lanes16> (&weights)[Count]) {
  const Lanes32 d;
  auto even = hn::Zero(d);
  auto odd = hn::Zero(d);
  for (std::size_t k = 0; k < Count; ++k) {
    even = hn::ReorderWidenMulAccumulate(d, samples[k], weights[k], even, odd);
  }
  return hn::RearrangeToOddPlusEven(even, odd);
}

}  // namespace sailmap::fixed::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
