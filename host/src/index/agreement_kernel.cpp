// Both constraints on codes, see agreement.hpp: sixteen-bit arithmetic, a lane for each of 32 images.
#include <algorithm>
#include <bit>

#include "kernels.hpp"
#include "plain_agreement.hpp"
#include "simd/sized_vectors.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "index/agreement_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "index/code_products-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sailmap::index {
namespace HWY_NAMESPACE {
#if HWY_TARGET == HWY_SCALAR

std::uint32_t agreeing(const Batch& batch, const AgreementQuery& query, AgreementWork& /*work*/) {
  return plain::agreeing(batch, query);
}

#else

namespace {

using Numbers = hn::RebindToUnsigned<Pairs>;
using NumberVector = hn::Vec<Numbers>;

HWY_INLINE PairVector load(const AgreementWork::Row& row, std::size_t lane) {
  return hn::LoadU(Pairs(), row.data() + lane);
}
HWY_INLINE NumberVector load_numbers(const AgreementWork::Row& row, std::size_t lane) {
  return hn::BitCast(Numbers(), load(row, lane));
}
template <class V>
HWY_INLINE void store(V vector, AgreementWork::Row& row, std::size_t lane) {
  hn::StoreU(hn::BitCast(Pairs(), vector), Pairs(), row.data() + lane);
}

HWY_INLINE hn::Mask<Numbers> at_most(NumberVector a, NumberVector b) {
  return hn::Eq(hn::SaturatedSub(a, b), hn::Zero(Numbers()));
}

// The squares of two signed bytes, summed; more than any limit when one is beyond 127.
HWY_INLINE PairVector squared_length(PairVector displacement) {
  const hn::Repartition<std::int8_t, Pairs> bytes;
  const hn::RebindToUnsigned<decltype(bytes)> sizes;
  const auto size =
      hn::Min(hn::BitCast(sizes, hn::Abs(hn::BitCast(bytes, displacement))), hn::Set(sizes, 127));
  const PairVector pairs = hn::BitCast(Pairs(), size);
  return dot(pairs, pairs);
}

HWY_INLINE void prepare_slots(const Batch& batch, const AgreementQuery& query, AgreementWork& work) {
  const Pairs d;
  const PairVector beyond = hn::Set(d, static_cast<std::int16_t>(query.largest_squared_offset + 1));
  for (std::size_t slot = 0; slot < batch.slots(); ++slot) {
    const auto* rows = reinterpret_cast<const std::int16_t*>(batch.codes.data() + slot * Batch::slot_bytes);
    for (std::size_t lane = 0; lane < batch_images; lane += hn::Lanes(d)) {
      const auto row = [&](std::size_t i) HWY_ATTR { return hn::LoadU(d, rows + i * batch_images + lane); };
      static_assert(direction_rows == 4);
      store(hn::Add(hn::Add(direction_term(row(0)), direction_term(row(1))),
                    hn::Add(direction_term(row(2)), direction_term(row(3)))),
            work.slots[slot].square, lane);
      store(row(4), work.slots[slot].place, lane);
      const auto filled =
          hn::Gt(hn::LoadU(d, batch.counts.data() + lane), hn::Set(d, static_cast<std::int16_t>(slot)));
      store(hn::IfThenElse(filled, beyond, hn::Zero(d)), work.slots[slot].beyond, lane);
    }
  }
}

// The least of the squared distances of a region's admissible candidates. Those of all, and their
// displacements, are kept in the slots.
HWY_INLINE NumberVector squared_distances(const Batch& batch, const AgreementRegion& region, Slots slots,
                                          AgreementWork& work, std::size_t lane) {
  const Pairs d;
  const hn::Repartition<std::int8_t, Pairs> bytes;
  const PairVector q0 = hn::Set(d, region.screen.pairs[0]);
  const PairVector q1 = hn::Set(d, region.screen.pairs[1]);
  const PairVector q2 = hn::Set(d, region.screen.pairs[2]);
  const PairVector q3 = hn::Set(d, region.screen.pairs[3]);
  const PairVector rest = hn::Set(d, region.screen.descriptor_rest);
  const auto place = hn::BitCast(bytes, hn::Set(d, region.place));
  const PairVector none = hn::Set(d, -1);  // no_distance
  NumberVector least = hn::Set(Numbers(), no_distance);
  for (std::size_t slot = slots.begin; slot < slots.end; ++slot) {
    const auto* rows = reinterpret_cast<const std::int16_t*>(batch.codes.data() + slot * Batch::slot_bytes);
    const auto product = [&](std::size_t i, PairVector q)
                             HWY_ATTR { return dot(q, hn::LoadU(d, rows + i * batch_images + lane)); };
    AgreementWork::Slot& candidate = work.slots[slot];
    const PairVector products =
        hn::Add(hn::Add(product(0, q0), product(1, q1)), hn::Add(product(2, q2), product(3, q3)));
    const PairVector distance = hn::Sub(hn::Add(load(candidate.square, lane), rest), products);
    const PairVector displacement =
        hn::BitCast(d, hn::SaturatedSub(hn::BitCast(bytes, load(candidate.place, lane)), place));
    const auto admissible = hn::Lt(squared_length(displacement), load(candidate.beyond, lane));
    const PairVector squared = hn::IfThenElse(admissible, distance, none);
    store(squared, candidate.squared, lane);
    store(displacement, candidate.displacement, lane);
    least = hn::Min(least, hn::BitCast(Numbers(), squared));
  }
  return least;
}

// Candidates whose squared distances keep a limit: how many there are, and the displacements of some.
struct Alternatives {
  NumberVector count;
  PairVector displacement[alternatives_kept];
};

HWY_INLINE Alternatives alternatives(NumberVector limit, Slots slots, const AgreementWork& work,
                                     std::size_t lane) {
  const Pairs d;
  Alternatives out;
  out.count = hn::Zero(Numbers());
  for (PairVector& displacement : out.displacement) displacement = hn::Zero(d);
  for (std::size_t slot = slots.begin; slot < slots.end; ++slot) {
    const AgreementWork::Slot& candidate = work.slots[slot];
    const auto within = at_most(load_numbers(candidate.squared, lane), limit);
    const auto moves = hn::RebindMask(d, within);
    for (std::size_t k = alternatives_kept - 1; k > 0; --k) {
      out.displacement[k] = hn::IfThenElse(moves, out.displacement[k - 1], out.displacement[k]);
    }
    out.displacement[0] = hn::IfThenElse(moves, load(candidate.displacement, lane), out.displacement[0]);
    out.count = hn::Sub(out.count, hn::VecFromMask(Numbers(), within));
  }
  return out;
}

// Of each number, as a float, and back: rounded down, and saturated.
template <class Function>
HWY_INLINE NumberVector converted(NumberVector numbers, float most, const Function& function) {
  const hn::RepartitionToWide<Pairs> d32;
  const hn::Repartition<float, Pairs> df;
  const hn::Half<Numbers> half;
  const auto convert = [&](auto part) HWY_ATTR {
    const auto values = function(hn::ConvertTo(df, hn::PromoteTo(d32, part)));
    return hn::DemoteTo(half, hn::ConvertTo(d32, hn::Min(values, hn::Set(df, most))));
  };
  return hn::Combine(Numbers(), convert(hn::UpperHalf(half, numbers)), convert(hn::LowerHalf(half, numbers)));
}

HWY_INLINE std::uint32_t bits(hn::Mask<Numbers> mask, std::size_t lane) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Numbers(), mask, bytes);
  std::uint32_t out = 0;
  for (std::size_t i = 0; i < 4; ++i) out |= static_cast<std::uint32_t>(bytes[i]) << (8 * i);
  return out << lane;
}

// Alternatives beyond the first, per image.
struct Extras {
  std::array<std::uint8_t, batch_images> count{};
  std::uint8_t most = 0;
  std::uint32_t too_many = 0;

  HWY_INLINE void add(std::uint32_t images, const AgreementWork::Row& displacement, AgreementWork& work) {
    for (; images != 0; images &= images - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(images));
      if (count[lane] == most_extras) {
        too_many |= 1U << lane;
        continue;
      }
      AgreementWork::Nearest& extra = work.extras[count[lane]++];
      extra.displacement[lane] = displacement[lane];
      extra.matched[lane] = -1;
      most = std::max(most, count[lane]);
    }
  }
};

HWY_INLINE void find_nearest(const Batch& batch, const AgreementQuery& query, std::size_t i,
                             AgreementWork& work, Extras& extras) {
  const Numbers d;
  const hn::Repartition<float, Pairs> df;
  const AgreementRegion& region = query.regions[i];
  AgreementWork::Nearest& nearest = work.nearest[i];
  const Slots slots =
      slots_within_reach(batch.columns, batch.slots(), region.screen.first_column, region.screen.last_column);
  std::uint32_t more_than[alternatives_kept + 1] = {};  // alternatives: a bit for each image
  alignas(64) AgreementWork::Row displacements[alternatives_kept];
  for (std::size_t lane = 0; lane < batch_images; lane += hn::Lanes(d)) {
    const NumberVector least = squared_distances(batch, region, slots, work, lane);
    const NumberVector limit = converted(least, most_distance, [&](auto squared) HWY_ATTR {
      const auto above =
          hn::Add(hn::Sqrt(hn::Add(squared, hn::Set(df, room_above))), hn::Set(df, 2 * region.error));
      return hn::Mul(hn::Mul(above, above), hn::Set(df, rounding_room));
    });
    const NumberVector cost = converted(least, UINT16_MAX, [&](auto squared) HWY_ATTR {
      const auto below = hn::Max(hn::Sub(hn::Sqrt(squared), hn::Set(df, region.error)), hn::Zero(df));
      return hn::Mul(below, hn::Set(df, query.cost_of_step));
    });
    const Alternatives found = alternatives(limit, slots, work, lane);
    const auto more = [&](std::uint16_t count) HWY_ATTR {
      return hn::Ne(hn::SaturatedSub(found.count, hn::Set(d, count)), hn::Zero(d));
    };
    const NumberVector matched = hn::VecFromMask(d, more(0));
    const NumberVector doubtful = hn::VecFromMask(d, more(1));
    const NumberVector certain = hn::AndNot(doubtful, matched);
    store(found.displacement[0], nearest.displacement, lane);
    store(matched, nearest.matched, lane);
    store(hn::And(certain, hn::Set(d, 1)), nearest.certain, lane);
    store(hn::And(certain, cost), nearest.cost, lane);
    store(hn::And(doubtful, cost), nearest.doubtful_cost, lane);
    for (std::size_t k = 1; k <= alternatives_kept; ++k) {
      more_than[k] |= bits(more(static_cast<std::uint16_t>(k)), lane);
    }
    for (std::size_t k = 1; k < alternatives_kept; ++k) store(found.displacement[k], displacements[k], lane);
  }
  for (std::size_t k = 1; k < alternatives_kept; ++k) extras.add(more_than[k], displacements[k], work);
  extras.too_many |= more_than[alternatives_kept];
}

// How many certain regions agree with a displacement, and the sum of their costs.
HWY_INLINE void support(const AgreementQuery& query, const AgreementWork& work, std::size_t lane,
                        AgreementWork::Nearest& of) {
  const Pairs d;
  const hn::Repartition<std::int8_t, Pairs> bytes;
  const auto common = hn::BitCast(bytes, load(of.displacement, lane));
  const PairVector beyond = hn::Set(d, static_cast<std::int16_t>(query.largest_squared_spread + 1));
  PairVector count = hn::Zero(d);
  NumberVector sum = hn::Zero(Numbers());
  for (std::size_t i = 0; i < query.regions.size(); ++i) {
    const AgreementWork::Nearest& other = work.nearest[i];
    const auto apart = hn::Sub(hn::BitCast(bytes, load(other.displacement, lane)), common);
    const auto size = hn::BitCast(d, hn::Abs(apart));
    const auto agrees = hn::Lt(dot(size, size), beyond);
    count = hn::Add(count, hn::IfThenElseZero(agrees, load(other.certain, lane)));
    sum = hn::SaturatedAdd(
        sum, hn::IfThenElseZero(hn::RebindMask(Numbers(), agrees), load_numbers(other.cost, lane)));
  }
  store(count, of.agreeing, lane);
  store(sum, of.sum, lane);
}

HWY_INLINE std::uint32_t decide(const AgreementQuery& query, const AgreementWork& work, std::size_t extras,
                                std::size_t lane) {
  const Numbers d;
  NumberVector least = hn::Zero(d);  // of |MR|
  NumberVector doubtful = hn::Zero(d);
  for (std::size_t i = 0; i < query.regions.size(); ++i) {
    const AgreementWork::Nearest& of = work.nearest[i];
    const NumberVector certain = load_numbers(of.certain, lane);
    least = hn::Max(least, hn::Mul(certain, load_numbers(of.agreeing, lane)));
    doubtful = hn::Sub(doubtful, hn::Add(load_numbers(of.matched, lane), certain));
  }
  const NumberVector unit = hn::Set(d, query.cost_unit);
  const NumberVector most_each = query.squared ? hn::Mul(hn::Add(least, least), unit) : unit;
  NumberVector doubtful_cost = hn::Zero(d);
  for (std::size_t i = 0; i < query.regions.size(); ++i) {
    doubtful_cost = hn::SaturatedAdd(doubtful_cost,
                                     hn::Min(load_numbers(work.nearest[i].doubtful_cost, lane), most_each));
  }
  NumberVector passing = hn::Zero(d);
  const auto consider = [&](const AgreementWork::Nearest& of) HWY_ATTR {
    const NumberVector count = hn::Add(load_numbers(of.agreeing, lane), doubtful);
    const NumberVector gain = hn::Mul(query.squared ? hn::Mul(count, count) : count, unit);
    const NumberVector cost = hn::SaturatedAdd(load_numbers(of.sum, lane), doubtful_cost);
    const NumberVector enough = hn::VecFromMask(d, hn::And(at_most(least, count), at_most(cost, gain)));
    passing = hn::Or(passing, hn::And(enough, load_numbers(of.matched, lane)));
  };
  for (std::size_t i = 0; i < query.regions.size(); ++i) consider(work.nearest[i]);
  for (std::size_t i = 0; i < extras; ++i) consider(work.extras[i]);
  return bits(hn::MaskFromVec(passing), lane);
}

}  // namespace

std::uint32_t agreeing(const Batch& batch, const AgreementQuery& query, AgreementWork& work) {
  prepare_slots(batch, query, work);
  for (AgreementWork::Nearest& extra : work.extras) extra.matched.fill(0);
  Extras extras;
  for (std::size_t i = 0; i < query.regions.size(); ++i) find_nearest(batch, query, i, work, extras);
  std::uint32_t passing = extras.too_many;
  for (std::size_t lane = 0; lane < batch_images; lane += hn::Lanes(Pairs())) {
    for (AgreementWork::Nearest& of : work.nearest) support(query, work, lane, of);
    for (std::size_t i = 0; i < extras.most; ++i) support(query, work, lane, work.extras[i]);
    passing |= decide(query, work, extras.most, lane);
  }
  return passing;
}

#endif  // HWY_SCALAR
}  // namespace HWY_NAMESPACE
}  // namespace sailmap::index
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sailmap::index {

HWY_EXPORT(agreeing);

std::uint32_t agreeing_images(const Batch& batch, const AgreementQuery& query, AgreementWork& work) {
  return HWY_DYNAMIC_DISPATCH(agreeing)(batch, query, work);
}

}  // namespace sailmap::index
#endif  // HWY_ONCE
