// Both constraints in single precision, see estimate.hpp: a vector holds regions of the query.
#include <algorithm>
#include <bit>

#include "kernels.hpp"
#include "plain_kernels.hpp"
#include "simd/sized_vectors.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "index/estimate_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sailmap::index {
namespace HWY_NAMESPACE {
#if HWY_TARGET == HWY_SCALAR

ConsistentMatches consistent(const QueryLanes& lanes, const Region* candidates, std::size_t count,
                             EstimateWork& work) {
  return plain::consistent(lanes, candidates, count, work);
}

#else

namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, lane_padding>;
using FloatVector = hn::Vec<Floats>;

// For a vector of query regions the nearest admissible candidate: squared distance, displacement.
struct Nearest {
  FloatVector least, dx, dy;
  bool ambiguous;
};

// Which of the (up to 64) candidates from `first` on have columns within reach.
HWY_INLINE std::uint64_t within_reach(const QueryLanes::Reach& reach, const float* x, std::size_t first,
                                      std::size_t count) {
  const Floats d;
  const FloatVector least = hn::Set(d, reach.first);
  const FloatVector most = hn::Set(d, reach.last);
  std::uint64_t within = 0;
  for (std::size_t j = 0; j < std::min<std::size_t>(64, count - first); j += hn::Lanes(d)) {
    const FloatVector columns = hn::LoadU(d, x + first + j);
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::And(hn::Ge(columns, least), hn::Le(columns, most)), bits);
    within |= static_cast<std::uint64_t>(bits[0]) << j;
  }
  return within;
}

HWY_INLINE Nearest nearest(const QueryLanes& lanes, std::size_t lane, const Region* candidates,
                           std::size_t count, const EstimateWork& work) {
  const Floats d;
  const FloatVector largest = hn::Set(d, lanes.largest_squared_offset);
  const FloatVector none = hn::Set(d, no_candidate);
  const FloatVector x = hn::LoadU(d, lanes.x.data() + lane);
  const FloatVector y = hn::LoadU(d, lanes.y.data() + lane);
  FloatVector from[feature_count];
  for (std::size_t i = 0; i < feature_count; ++i) from[i] = hn::LoadU(d, lanes.descriptor[i].data() + lane);
  FloatVector least = none;
  FloatVector second = none;
  FloatVector least_dx = none;
  FloatVector least_dy = none;
  const auto consider = [&](std::size_t j) HWY_ATTR {
    const Region& to = candidates[j];
    const FloatVector dx = hn::Sub(x, hn::Set(d, work.x[j]));
    const FloatVector dy = hn::Sub(y, hn::Set(d, work.y[j]));
    const auto near = hn::Le(hn::MulAdd(dx, dx, hn::Mul(dy, dy)), largest);
    FloatVector even = hn::Zero(d);
    FloatVector odd = hn::Zero(d);
    static_assert(feature_count % 2 == 0);
    for (std::size_t i = 0; i < feature_count; i += 2) {
      const FloatVector a = hn::Sub(from[i], hn::Set(d, to.descriptor[i]));
      const FloatVector b = hn::Sub(from[i + 1], hn::Set(d, to.descriptor[i + 1]));
      even = hn::MulAdd(a, a, even);
      odd = hn::MulAdd(b, b, odd);
    }
    const FloatVector squared = hn::IfThenElse(near, hn::Add(even, odd), none);
    const auto nearer = hn::Lt(squared, least);
    second = hn::Min(second, hn::Max(squared, least));
    least_dx = hn::IfThenElse(nearer, dx, least_dx);
    least_dy = hn::IfThenElse(nearer, dy, least_dy);
    least = hn::Min(least, squared);
  };
  const QueryLanes::Reach& reach = lanes.reaches[lane / lane_padding];
  for (std::size_t first = 0; first < count; first += 64) {
    std::uint64_t left = within_reach(reach, work.x.data(), first, count);
    for (; left != 0; left &= left - 1) consider(first + static_cast<std::size_t>(std::countr_zero(left)));
  }
  const auto certain = hn::MulAdd(least, hn::Set(d, 1 + ambiguous_part), hn::Set(d, underflow));
  const auto doubtful = hn::And(hn::Lt(least, none), hn::Le(second, certain));
  return {least, least_dx, least_dy, !hn::AllFalse(d, doubtful)};
}

// Positions of the candidates as numbers, and beyond them some that are nowhere.
HWY_INLINE void set_positions(const Region* candidates, std::size_t count, EstimateWork& work) {
  const Floats d;
  const hn::RebindToSigned<Floats> di;
  const std::size_t padded = count + lane_padding;
  work.pairs.resize(std::max(work.pairs.size(), padded));
  work.x.resize(std::max(work.x.size(), padded));
  work.y.resize(work.x.size());
  for (std::size_t j = 0; j < count; ++j) {
    const auto x = static_cast<std::uint16_t>(candidates[j].x);
    const auto y = static_cast<std::uint16_t>(candidates[j].y);
    work.pairs[j] = static_cast<std::int32_t>(x | static_cast<std::uint32_t>(y) << 16U);
  }
  for (std::size_t j = 0; j < count; j += hn::Lanes(d)) {
    const auto pairs = hn::LoadU(di, work.pairs.data() + j);
    const auto x = hn::ShiftRight<16>(hn::ShiftLeft<16>(pairs));
    hn::StoreU(hn::ConvertTo(d, x), d, work.x.data() + j);
    hn::StoreU(hn::ConvertTo(d, hn::ShiftRight<16>(pairs)), d, work.y.data() + j);
  }
  std::fill_n(work.x.data() + count, lane_padding, no_candidate);
}

// For a vector of query regions, how many displacements agree with theirs, and the sum of their distances.
// Regions without a candidate agree with none that has one.
struct Support {
  FloatVector count, sum;
};
HWY_INLINE Support supported(const QueryLanes& lanes, std::size_t lane, const float* distance,
                             const float* dx, const float* dy) {
  const Floats d;
  const FloatVector x = hn::LoadU(d, dx + lane);
  const FloatVector y = hn::LoadU(d, dy + lane);
  const FloatVector largest = hn::Set(d, lanes.largest_squared_spread);
  Support out{hn::Zero(d), hn::Zero(d)};
  for (std::size_t other = 0; other < lanes.count; ++other) {
    const FloatVector ex = hn::Sub(x, hn::Set(d, dx[other]));
    const FloatVector ey = hn::Sub(y, hn::Set(d, dy[other]));
    const auto agree = hn::Le(hn::MulAdd(ex, ex, hn::Mul(ey, ey)), largest);
    out.count = hn::Add(out.count, hn::IfThenElseZero(agree, hn::Set(d, 1.0F)));
    out.sum = hn::Add(out.sum, hn::IfThenElseZero(agree, hn::Set(d, distance[other])));
  }
  return out;
}

}  // namespace

ConsistentMatches consistent(const QueryLanes& lanes, const Region* candidates, std::size_t count,
                             EstimateWork& work) {
  const Floats d;
  const std::size_t padded = lanes.x.size();
  float* distance = work.numbers.data();
  float* dx = distance + padded;
  float* dy = dx + padded;
  float* support = dy + padded;
  float* sum = support + padded;
  set_positions(candidates, count, work);
  for (std::size_t lane = 0; lane < padded; lane += hn::Lanes(d)) {
    const Nearest found = nearest(lanes, lane, candidates, count, work);
    if (found.ambiguous) return {0, 0, true};
    const FloatVector certain = hn::Max(hn::Sub(found.least, hn::Set(d, underflow)), hn::Zero(d));
    hn::StoreU(hn::Sqrt(certain), d, distance + lane);
    hn::StoreU(found.dx, d, dx + lane);
    hn::StoreU(found.dy, d, dy + lane);
  }
  for (std::size_t lane = 0; lane < padded; lane += hn::Lanes(d)) {
    const Support found = supported(lanes, lane, distance, dx, dy);
    const auto matched = hn::Lt(hn::LoadU(d, dx + lane), hn::Set(d, no_candidate));
    hn::StoreU(hn::IfThenElseZero(matched, found.count), d, support + lane);
    hn::StoreU(found.sum, d, sum + lane);
  }
  float most = 0;
  std::size_t common = 0;
  for (const std::size_t lane : lanes.order) {
    common = support[lane] > most ? lane : common;
    most = std::max(most, support[lane]);
  }
  if (most == 0) return {};
  return {static_cast<int>(most), sum[common], false};
}

#endif  // HWY_SCALAR
}  // namespace HWY_NAMESPACE
}  // namespace sailmap::index
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sailmap::index {

HWY_EXPORT(consistent);

ConsistentMatches consistent_matches(const QueryLanes& lanes, const Region* candidates, std::size_t count,
                                     EstimateWork& work) {
  return HWY_DYNAMIC_DISPATCH(consistent)(lanes, candidates, count, work);
}

}  // namespace sailmap::index
#endif  // HWY_ONCE
