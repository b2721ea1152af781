#include "kernels.hpp"

#include <algorithm>

#include "plain_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "index/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sailmap::index {
namespace HWY_NAMESPACE {
#if HWY_TARGET == HWY_SCALAR

std::uint64_t screen(const Block& block, const ScreenQuery& query, std::uint8_t* work) {
  return plain::screen(block, query, work);
}

void nearest(const QueryLanes& lanes, const Region* candidates, std::size_t count, float* out) {
  plain::nearest(lanes, candidates, count, out);
}

#else

namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Bytes = hn::CappedTag<std::uint8_t, block_images>;
using Vector = hn::Vec<Bytes>;

// Codes of `lanes` images as whole bytes: eight rows for each slot.
HWY_INLINE void unpack(const Block& block, std::size_t first_lane, std::uint8_t* numbers) {
  const Bytes d;
  const hn::RepartitionToWide<Bytes> d16;
  const Vector low_bits = hn::Set(d, 0x0F);
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t rows = block.slots() * code_bytes;
  for (std::size_t row = 0; row < rows; ++row) {
    const Vector packed = hn::LoadU(d, block.codes.data() + row * block_images + first_lane);
    const Vector shifted = hn::BitCast(d, hn::ShiftRight<4>(hn::BitCast(d16, packed)));
    hn::StoreU(hn::And(packed, low_bits), d, numbers + 2 * row * lanes);
    hn::StoreU(hn::And(shifted, low_bits), d, numbers + (2 * row + 1) * lanes);
  }
}

// The distance code of each squared one, rounded down: by the number itself below 16, by its quarter below
// 64, by its sixteenth above.
HWY_INLINE Vector root(Vector squared, const std::uint8_t* tables) {
  const Bytes d;
  const hn::RepartitionToWide<Bytes> d16;
  const Vector low_bits = hn::Set(d, 0x0F);
  const auto wide = hn::BitCast(d16, squared);
  const Vector quarter = hn::And(hn::BitCast(d, hn::ShiftRight<2>(wide)), low_bits);
  const Vector sixteenth = hn::And(hn::BitCast(d, hn::ShiftRight<4>(wide)), low_bits);
  const Vector fine = hn::TableLookupBytes(hn::LoadDup128(d, tables), hn::And(squared, low_bits));
  const Vector middle = hn::TableLookupBytes(hn::LoadDup128(d, tables + 16), quarter);
  const Vector coarse = hn::TableLookupBytes(hn::LoadDup128(d, tables + 32), sixteenth);
  const Vector below_64 = hn::IfThenElse(hn::Lt(squared, hn::Set(d, 16)), fine, middle);
  return hn::IfThenElse(hn::Lt(squared, hn::Set(d, 64)), below_64, coarse);
}

// The least bound over all slots for one region of the query: a distance code for each image.
HWY_INLINE Vector least_bound(const Block& block, const ScreenQuery& query, std::size_t region,
                              const std::uint8_t* numbers) {
  const Bytes d;
  const hn::RebindToSigned<Bytes> di;
  const std::size_t lanes = hn::Lanes(d);
  const auto& tables = query.tables[region];
  const auto columns = query.columns[region];
  static_assert(code_numbers == 8);
  const Vector t0 = hn::LoadDup128(d, tables[0].data());
  const Vector t1 = hn::LoadDup128(d, tables[1].data());
  const Vector t2 = hn::LoadDup128(d, tables[2].data());
  const Vector t3 = hn::LoadDup128(d, tables[3].data());
  const Vector t4 = hn::LoadDup128(d, tables[4].data());
  const Vector t5 = hn::LoadDup128(d, tables[5].data());
  const Vector t6 = hn::LoadDup128(d, tables[6].data());
  const Vector t7 = hn::LoadDup128(d, tables[7].data());
  Vector least = hn::Set(d, 255);
  const std::size_t slots = block.slots();
  for (std::size_t slot = 0; slot < slots; ++slot) {
    if (block.columns[slot].last < columns.first || block.columns[slot].first > columns.last) continue;
    const std::uint8_t* row = numbers + slot * code_numbers * lanes;
    const auto look_up = [&](Vector table, std::size_t number) HWY_ATTR {
      return hn::TableLookupBytes(table, hn::LoadU(d, row + number * lanes));
    };
    const Vector a = hn::SaturatedAdd(look_up(t0, 0), look_up(t1, 1));
    const Vector b = hn::SaturatedAdd(look_up(t2, 2), look_up(t3, 3));
    const Vector c = hn::SaturatedAdd(look_up(t4, 4), look_up(t5, 5));
    const Vector squared = hn::SaturatedAdd(hn::SaturatedAdd(a, b), c);
    const Vector position = hn::SaturatedAdd(look_up(t6, 6), look_up(t7, 7));
    const Vector too_far = hn::BitCast(d, hn::BroadcastSignBit(hn::BitCast(di, position)));
    least = hn::Min(least, hn::Or(squared, too_far));
  }
  return root(least, query.roots.data());
}

// Which images have a k for which the k smallest of their bounds (rows of `bounds`, sorted) keep the limit.
HWY_INLINE std::uint64_t within_limits(const std::uint8_t* bounds, const ScreenQuery& query) {
  const Bytes d;
  const hn::RepartitionToWide<Bytes> d16;
  const hn::Half<Bytes> dh;
  const std::size_t lanes = hn::Lanes(d);
  auto low_sum = hn::Zero(d16);
  auto high_sum = hn::Zero(d16);
  auto low_excess = hn::Set(d16, 0xFFFF);
  auto high_excess = low_excess;
  for (std::size_t k = 0; k < query.limits.size(); ++k) {
    const Vector bound = hn::LoadU(d, bounds + k * lanes);
    const auto limit = hn::Set(d16, query.limits[k]);
    low_sum = hn::SaturatedAdd(low_sum, hn::PromoteTo(d16, hn::LowerHalf(dh, bound)));
    high_sum = hn::SaturatedAdd(high_sum, hn::PromoteTo(d16, hn::UpperHalf(dh, bound)));
    low_excess = hn::Min(low_excess, hn::SaturatedSub(low_sum, limit));
    high_excess = hn::Min(high_excess, hn::SaturatedSub(high_sum, limit));
  }
  std::uint8_t bits[16] = {};
  const auto bits_of = [&](auto excess) HWY_ATTR {
    std::fill(std::begin(bits), std::end(bits), std::uint8_t{0});
    hn::StoreMaskBits(d16, hn::Eq(excess, hn::Zero(d16)), bits);
    std::uint64_t out = 0;
    for (std::size_t i = 0; i < 4; ++i) out |= static_cast<std::uint64_t>(bits[i]) << (8 * i);
    return out;
  };
  return bits_of(low_excess) | (bits_of(high_excess) << (lanes / 2));
}

}  // namespace

std::uint64_t screen(const Block& block, const ScreenQuery& query, std::uint8_t* work) {
  const Bytes d;
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t regions = query.tables.size();
  std::uint8_t* bounds = work;
  std::uint8_t* numbers = work + regions * block_images;
  std::uint64_t passing = 0;
  for (std::size_t lane = 0; lane < block_images; lane += lanes) {
    unpack(block, lane, numbers);
    for (std::size_t i = 0; i < regions; ++i) {
      hn::StoreU(least_bound(block, query, i, numbers), d, bounds + i * lanes);
    }
    for (const auto& [i, j] : query.network) {
      const Vector a = hn::LoadU(d, bounds + i * lanes);
      const Vector b = hn::LoadU(d, bounds + j * lanes);
      hn::StoreU(hn::Min(a, b), d, bounds + i * lanes);
      hn::StoreU(hn::Max(a, b), d, bounds + j * lanes);
    }
    passing |= within_limits(bounds, query) << lane;
  }
  return passing;
}

void nearest(const QueryLanes& lanes, const Region* candidates, std::size_t count, float* out) {
  const hn::CappedTag<float, lane_padding> d;
  const auto radius = hn::Set(d, lanes.squared_radius);
  const auto none = hn::Set(d, 1e31F);
  for (std::size_t lane = 0; lane < lanes.x.size(); lane += hn::Lanes(d)) {
    const auto x = hn::LoadU(d, lanes.x.data() + lane);
    const auto y = hn::LoadU(d, lanes.y.data() + lane);
    auto least = none;
    for (std::size_t j = 0; j < count; ++j) {
      const Region& to = candidates[j];
      const auto dx = hn::Sub(x, hn::Set(d, to.x));
      const auto dy = hn::Sub(y, hn::Set(d, to.y));
      const auto near = hn::Le(hn::MulAdd(dx, dx, hn::Mul(dy, dy)), radius);
      if (hn::AllFalse(d, near)) continue;
      auto even = hn::Zero(d);
      auto odd = hn::Zero(d);
      static_assert(feature_count % 2 == 0);
      for (std::size_t i = 0; i < feature_count; i += 2) {
        const auto a = hn::Sub(hn::LoadU(d, lanes.descriptor[i].data() + lane), hn::Set(d, to.descriptor[i]));
        const auto b =
            hn::Sub(hn::LoadU(d, lanes.descriptor[i + 1].data() + lane), hn::Set(d, to.descriptor[i + 1]));
        even = hn::MulAdd(a, a, even);
        odd = hn::MulAdd(b, b, odd);
      }
      least = hn::Min(least, hn::IfThenElse(near, hn::Add(even, odd), none));
    }
    hn::StoreU(least, d, out + lane);
  }
}

#endif  // HWY_SCALAR
}  // namespace HWY_NAMESPACE
}  // namespace sailmap::index
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sailmap::index {

HWY_EXPORT(screen);
HWY_EXPORT(nearest);

std::size_t work_bytes(std::size_t slots, std::size_t regions) {
  return (regions + slots * code_numbers) * block_images;
}

std::uint64_t screen_block(const Block& block, const ScreenQuery& query, std::uint8_t* work) {
  return HWY_DYNAMIC_DISPATCH(screen)(block, query, work);
}

void nearest_squared(const QueryLanes& lanes, const Region* candidates, std::size_t count, float* nearest) {
  HWY_DYNAMIC_DISPATCH(nearest)(lanes, candidates, count, nearest);
}

}  // namespace sailmap::index
#endif  // HWY_ONCE
