// Products of code bytes, in sixteen-bit lanes, and which slots are worth them: included once per instruction
// set, by the kernels.
#if defined(SAILMAP_CODE_PRODUCTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SAILMAP_CODE_PRODUCTS_INL
#undef SAILMAP_CODE_PRODUCTS_INL
#else
#define SAILMAP_CODE_PRODUCTS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "index/kernels.hpp"

HWY_BEFORE_NAMESPACE();
namespace sailmap::index {
namespace HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR

namespace hn = hwy::HWY_NAMESPACE;

using Pairs = hn::CappedTag<std::int16_t, group_images>;  // codes, two to a lane
using PairVector = hn::Vec<Pairs>;

// For each lane the saturated sum of the products of its two bytes, unsigned ones with signed ones.
HWY_INLINE PairVector dot(PairVector unsigned_bytes, PairVector signed_bytes) {
#if HWY_TARGET == HWY_SSSE3 || HWY_TARGET == HWY_SSE4
  return PairVector{_mm_maddubs_epi16(unsigned_bytes.raw, signed_bytes.raw)};
#elif HWY_TARGET == HWY_AVX2
  return PairVector{_mm256_maddubs_epi16(unsigned_bytes.raw, signed_bytes.raw)};
#elif HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  return PairVector{_mm512_maddubs_epi16(unsigned_bytes.raw, signed_bytes.raw)};
#else
  const hn::RebindToUnsigned<Pairs> du;
  const auto low = hn::Mul(hn::And(unsigned_bytes, hn::Set(Pairs(), 0xFF)),
                           hn::ShiftRight<8>(hn::ShiftLeft<8>(signed_bytes)));
  const auto high = hn::BitCast(Pairs(), hn::ShiftRight<8>(hn::BitCast(du, unsigned_bytes)));
  return hn::SaturatedAdd(low, hn::Mul(high, hn::ShiftRight<8>(signed_bytes)));
#endif
}

// The two signed bytes' squares, summed: up to 127 each.
HWY_INLINE PairVector squares(PairVector codes) {
  const hn::Repartition<std::int8_t, Pairs> bytes;
  const auto size = hn::BitCast(Pairs(), hn::Abs(hn::BitCast(bytes, codes)));
  return dot(size, size);
}

// |c|^2 + direction_origin c of two directions' codes: c (c + direction_origin).
HWY_INLINE PairVector direction_term(PairVector codes) {
  static_assert(direction_origin == 0x80);
  return dot(hn::Xor(codes, hn::Set(Pairs(), static_cast<std::int16_t>(0x8080))), codes);
}

// Half |c|^2 + position_zero c of a position's codes, less the bias.
HWY_INLINE PairVector position_term(PairVector codes) {
  const Pairs d;
  const auto moved = dot(hn::Set(d, position_zero * 0x0101), codes);
  return hn::Add(hn::ShiftRight<1>(squares(codes)), hn::Sub(moved, hn::Set(d, position_bias)));
}

// Slots that may be within reach of some columns. Without a loop over them, whose end no processor foresees.
struct Slots {
  std::size_t begin = 0;
  std::size_t end = 0;
};
HWY_INLINE Slots slots_within_reach(const Columns& columns, std::size_t slots, std::uint8_t first_column,
                                    std::uint8_t last_column) {
  const hn::CappedTag<std::uint8_t, Columns::slots> d;
  const auto before = hn::Set(d, first_column);
  const auto behind = hn::Set(d, last_column);
  std::uint8_t reached[Columns::slots / 8 + 7] = {};  // as many bytes more as may be stored
  std::uint8_t not_beyond[Columns::slots / 8 + 7] = {};
  for (std::size_t i = 0; i < Columns::slots; i += hn::Lanes(d)) {
    const auto last = hn::LoadU(d, columns.last.data() + i);
    const auto first = hn::LoadU(d, columns.first.data() + i);
    hn::StoreMaskBits(d, hn::Eq(hn::Max(last, before), last), reached + i / 8);
    hn::StoreMaskBits(d, hn::Eq(hn::Min(first, behind), first), not_beyond + i / 8);
  }
  std::uint32_t bits[2];
  std::memcpy(&bits[0], reached, sizeof(bits[0]));
  std::memcpy(&bits[1], not_beyond, sizeof(bits[1]));
  static_assert(Columns::slots == 32);
  const auto begin = static_cast<std::size_t>(std::countr_zero(bits[0]));
  const auto end = Columns::slots - static_cast<std::size_t>(std::countl_zero(bits[1]));
  return {std::min(begin, slots), slots > Columns::slots ? slots : std::min(end, slots)};
}

#endif  // HWY_SCALAR
}  // namespace HWY_NAMESPACE
}  // namespace sailmap::index
HWY_AFTER_NAMESPACE();

#endif
