// Running sums along a vector; compiled once for each target (hence no #pragma once).
#if defined(SAILMAP_FIXED_PREFIX_SUM_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SAILMAP_FIXED_PREFIX_SUM_INL
#undef SAILMAP_FIXED_PREFIX_SUM_INL
#else
#define SAILMAP_FIXED_PREFIX_SUM_INL
#endif

#include "vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sailmap::fixed::HWY_NAMESPACE {

class PrefixSum {
  using Vector = hn::Vec<Words32>;
  static constexpr int block = 4;  // lanes of 128 bits, within which lanes are shifted

 public:
  PrefixSum() {
    const Words32 d;
    const int lanes = lanes_of(d);
    HWY_ALIGN std::int32_t last[16];
    for (int i = 0; i < lanes; ++i) last[i] = lanes - 1;
    last_ = hn::SetTableIndices(d, last);
    for (int s = 0; s < steps; ++s) {
      // The last lane of the block 2^s before, where there is one.
      HWY_ALIGN std::int32_t indices[16];
      HWY_ALIGN std::uint32_t masks[16];
      for (int i = 0; i < lanes; ++i) {
        const int from = (i / block + 1 - (1 << s)) * block - 1;
        indices[i] = std::max(from, 0);
        masks[i] = from >= 0 ? ~0U : 0U;
      }
      carry_[s] = hn::SetTableIndices(d, indices);
      carried_[s] = hn::Load(d, masks);
    }
  }

  // Lane i: the sum of lanes 0 to i.
  HWY_INLINE Vector of(Vector v) const {
    const Words32 d;
    v = hn::Add(v, hn::ShiftLeftLanes<1>(d, v));
    v = hn::Add(v, hn::ShiftLeftLanes<2>(d, v));
    for (int s = 0; s < steps; ++s) {
      v = hn::Add(v, hn::And(hn::TableLookupLanes(v, carry_[s]), carried_[s]));
    }
    return v;
  }

  // The last lane in all lanes.
  HWY_INLINE Vector last_of(Vector v) const { return hn::TableLookupLanes(v, last_); }

 private:
  using Indices = decltype(hn::SetTableIndices(Words32(), static_cast<const std::int32_t*>(nullptr)));
  // log2 of the number of blocks.
  static constexpr int steps = HWY_MAX_BYTES >= 64 ? 2 : HWY_MAX_BYTES >= 32 ? 1 : 0;

  Indices last_;
  Indices carry_[steps + 1];
  Vector carried_[steps + 1];
};

}  // namespace sailmap::fixed::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
