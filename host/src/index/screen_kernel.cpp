// Screening, see screen.hpp: sixteen-bit arithmetic on the codes of 64 images.
#include <algorithm>

#include "kernels.hpp"
#include "plain_kernels.hpp"
#include "simd/sized_vectors.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "index/screen_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "index/code_products-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sailmap::index {
namespace HWY_NAMESPACE {
#if HWY_TARGET == HWY_SCALAR

std::uint64_t screen(const Block& block, const Block& /*next*/, const ScreenQuery& query,
                     std::uint8_t* /*work*/) {
  return plain::screen(block, query);
}

#else

namespace {

using Bytes = hn::CappedTag<std::uint8_t, block_images>;
using Vector = hn::Vec<Bytes>;
using Distances = hn::RebindToUnsigned<Pairs>;
using DistanceVector = hn::Vec<Distances>;

// What distance and offset have of each candidate alone; positions of empty slots are beyond all limits,
// which are at most INT16_MAX. Rows of 64 numbers, descriptor and position for each slot.
HWY_INLINE void candidate_terms(const Block& block, std::int16_t* out) {
  const Pairs d;
  for (std::size_t slot = 0; slot < block.slots(); ++slot) {
    const auto* row = reinterpret_cast<const std::int16_t*>(block.codes.data() + slot * Block::slot_bytes);
    for (std::size_t lane = 0; lane < block_images; lane += hn::Lanes(d)) {
      const auto codes = [&](std::size_t i) HWY_ATTR { return hn::LoadU(d, row + i * block_images + lane); };
      static_assert(direction_rows == 4);
      const auto sum = hn::Add(hn::Add(direction_term(codes(0)), direction_term(codes(1))),
                               hn::Add(direction_term(codes(2)), direction_term(codes(3))));
      const auto count = hn::LoadU(d, block.counts.data() + lane);
      const auto filled = hn::Gt(count, hn::Set(d, static_cast<std::int16_t>(slot)));
      hn::StoreU(sum, d, out + 2 * slot * block_images + lane);
      hn::StoreU(hn::IfThenElse(filled, position_term(codes(4)), hn::Set(d, INT16_MAX)), d,
                 out + (2 * slot + 1) * block_images + lane);
    }
  }
}

// A region of the query in registers.
struct Probe {
  PairVector q0, q1, q2, q3, position, limit;
  PairVector least;  // squared distance, without |q|^2/4
};

HWY_INLINE Probe probe_of(const ScreenRegion& region, bool exact) {
  const Pairs d;
  return {hn::Set(d, region.pairs[0]), hn::Set(d, region.pairs[1]),
          hn::Set(d, region.pairs[2]), hn::Set(d, region.pairs[3]),
          hn::Set(d, region.pairs[4]), hn::Set(d, region.position_limits[exact ? 0 : 1]),
          hn::Set(d, INT16_MAX)};
}

// The least squared distance, no less than 0: what is beyond signed 16 bits came round below it.
HWY_INLINE DistanceVector squared_distance(const Probe& probe, const ScreenRegion& region) {
  const Pairs d;
  const auto rest = hn::Set(d, region.descriptor_rest);
  return hn::BitCast(Distances(), hn::Add(hn::Max(probe.least, hn::Neg(rest)), rest));
}

// Distance codes from the squared distances in code steps: rounded down, less the codes' errors.
HWY_INLINE void store_distances(DistanceVector squared, const ScreenRegion& region, float scale,
                                std::uint8_t* out) {
  const hn::RepartitionToWide<Pairs> d32;
  const hn::Repartition<float, Pairs> df;
  const hn::Rebind<std::uint8_t, decltype(d32)> d8;
  const hn::Half<Distances> half;
  const auto convert = [&](auto numbers, std::uint8_t* to) HWY_ATTR {
    const auto steps = hn::Sqrt(hn::ConvertTo(df, hn::PromoteTo(d32, numbers)));
    const auto codes = hn::Sub(hn::Mul(steps, hn::Set(df, scale)), hn::Set(df, region.error));
    hn::StoreU(hn::DemoteTo(d8, hn::ConvertTo(d32, codes)), d8, to);  // saturates
  };
  convert(hn::LowerHalf(half, squared), out);
  convert(hn::UpperHalf(half, squared), out + hn::Lanes(d32));
}

// The least squared distances over the slots, a lower bound for each image, for two regions of the query at a
// time (so that each candidate is loaded once for both).
struct Least {
  DistanceVector first, second;
};
HWY_INLINE Least least_distances(const Block& block, const Slots& slots, const ScreenRegion& first,
                                 const ScreenRegion& second, const std::int16_t* terms, bool exact,
                                 std::size_t lane) {
  const Pairs d;
  Probe a = probe_of(first, exact);
  Probe b = probe_of(second, exact);
  for (std::size_t slot = slots.begin; slot < slots.end; ++slot) {
    const auto* row = reinterpret_cast<const std::int16_t*>(block.codes.data() + slot * Block::slot_bytes);
    const PairVector c0 = hn::LoadU(d, row + lane);
    const PairVector c1 = hn::LoadU(d, row + block_images + lane);
    const PairVector c2 = hn::LoadU(d, row + 2 * block_images + lane);
    const PairVector c3 = hn::LoadU(d, row + 3 * block_images + lane);
    const PairVector c4 = hn::LoadU(d, row + 4 * block_images + lane);
    const PairVector descriptor = hn::LoadU(d, terms + 2 * slot * block_images + lane);
    const PairVector position = hn::LoadU(d, terms + (2 * slot + 1) * block_images + lane);
    const auto improve = [&](Probe& probe) HWY_ATTR {
      const auto products = hn::Add(hn::Add(dot(probe.q0, c0), dot(probe.q1, c1)),
                                    hn::Add(dot(probe.q2, c2), dot(probe.q3, c3)));
      const auto distance = hn::Sub(descriptor, products);
      const auto offset = hn::Sub(position, dot(probe.position, c4));
      const auto less = hn::Min(probe.least, distance);
      probe.least = hn::IfThenElse(hn::Lt(offset, probe.limit), less, probe.least);
    };
    improve(a);
    improve(b);
  }
  return {squared_distance(a, first), squared_distance(b, second)};
}

// A bit for each lane of 16 bits that is zero.
template <class D>
HWY_INLINE std::uint64_t zero_lanes(D d, hn::Vec<D> numbers) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, hn::Eq(numbers, hn::Zero(d)), bytes);
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < hn::Lanes(d); i += 8) bits |= static_cast<std::uint64_t>(bytes[i / 8]) << i;
  return bits;
}

// Which images have a squared distance that keeps the limit of the region.
HWY_INLINE std::uint64_t within_limit(DistanceVector least, const ScreenRegion& region) {
  const Distances d;
  return zero_lanes(d, hn::SaturatedSub(least, hn::Set(d, region.squared_limit)));
}

// Which images have a k for which the k smallest of their bounds (rows of `bounds`, sorted) keep the limit.
HWY_INLINE std::uint64_t within_limits(const std::uint8_t* bounds, const ScreenQuery& query) {
  const Bytes d;
  const hn::RepartitionToWide<Bytes> d16;
  const hn::Half<Bytes> dh;
  using Sums = hn::Vec<decltype(d16)>;
  Sums low_sum = hn::Zero(d16);
  Sums high_sum = low_sum;
  Sums low_excess = hn::Set(d16, 0xFFFF);
  Sums high_excess = low_excess;
  for (std::size_t k = 0; k < query.limits.size(); ++k) {
    const Vector bound = hn::LoadU(d, bounds + k * block_images);
    const Sums limit = hn::Set(d16, query.limits[k]);
    low_sum = hn::SaturatedAdd(low_sum, hn::PromoteTo(d16, hn::LowerHalf(dh, bound)));
    high_sum = hn::SaturatedAdd(high_sum, hn::PromoteTo(d16, hn::UpperHalf(dh, bound)));
    low_excess = hn::Min(low_excess, hn::SaturatedSub(low_sum, limit));
    high_excess = hn::Min(high_excess, hn::SaturatedSub(high_sum, limit));
  }
  return zero_lanes(d16, low_excess) | zero_lanes(d16, high_excess) << hn::Lanes(d16);
}

}  // namespace

std::uint64_t screen(const Block& block, const Block& next, const ScreenQuery& query, std::uint8_t* work) {
  const Bytes d;
  const std::size_t regions = query.regions.size();
  std::uint8_t* bounds = work;
  auto* terms = reinterpret_cast<std::int16_t*>(work + (regions + 1) * block_images);
  candidate_terms(block, terms);
  // A part with each two regions: all at once would be waited for.
  const std::size_t part = next.codes.size() / (block_groups * ((regions + 1) / 2)) + 1;
  const std::uint8_t* wanted = next.codes.data();
  const std::uint8_t* wanted_end = wanted + next.codes.size();
  const bool exact = query.exact_positions && block.exact_positions;
  std::uint64_t passing = 0;
  for (std::size_t group = 0; group < block_groups; ++group) {
    for (std::size_t i = 0; i < regions; i += 2) {
      const ScreenRegion& first = query.regions[i];
      const ScreenRegion& second = query.regions[std::min(i + 1, regions - 1)];
      const std::uint8_t* part_end = wanted + std::min<std::ptrdiff_t>(wanted_end - wanted, part);
      for (; wanted < part_end; wanted += 64) __builtin_prefetch(wanted, 0, 3);
      const Slots slots = slots_within_reach(block.columns[group], block.slots(),
                                             std::min(first.first_column, second.first_column),
                                             std::max(first.last_column, second.last_column));
      const std::size_t end = (group + 1) * group_images;
      for (std::size_t lane = group * group_images; lane < end; lane += hn::Lanes(Pairs())) {
        const Least least = least_distances(block, slots, first, second, terms, exact, lane);
        if (query.one_is_enough) {
          passing |= (within_limit(least.first, first) | within_limit(least.second, second)) << lane;
          continue;
        }
        std::uint8_t* out = bounds + i * block_images + lane;
        store_distances(least.first, first, query.scale, out);
        store_distances(least.second, second, query.scale, out + block_images);
      }
    }
  }
  if (query.one_is_enough) return passing;
  for (std::size_t lane = 0; lane < block_images; lane += hn::Lanes(d)) {
    for (const auto& [i, j] : query.network) {
      const Vector a = hn::LoadU(d, bounds + i * block_images + lane);
      const Vector b = hn::LoadU(d, bounds + j * block_images + lane);
      hn::StoreU(hn::Min(a, b), d, bounds + i * block_images + lane);
      hn::StoreU(hn::Max(a, b), d, bounds + j * block_images + lane);
    }
    passing |= within_limits(bounds + lane, query) << lane;
  }
  return passing;
}

#endif  // HWY_SCALAR
}  // namespace HWY_NAMESPACE
}  // namespace sailmap::index
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sailmap::index {

HWY_EXPORT(screen);

std::size_t work_bytes(std::size_t slots, std::size_t regions) {
  return (regions + 1 + 4 * slots) * block_images;
}

std::uint64_t screen_block(const Block& block, const Block& next, const ScreenQuery& query,
                           std::uint8_t* work) {
  return HWY_DYNAMIC_DISPATCH(screen)(block, next, query, work);
}

}  // namespace sailmap::index
#endif  // HWY_ONCE
