// Both constraints in single precision, see estimate.hpp: a vector holds regions of the query.
#include <algorithm>
#include <bit>

#include "kernels.hpp"
#include "plain_kernels.hpp"

// Vectors of a size unknown to the compiler cannot be members of structs.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
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

// How many displacements agree with (x, y).
HWY_INLINE std::size_t supporters(const float* dx, const float* dy, std::size_t lanes, float x, float y,
                                  float largest) {
  const Floats d;
  std::size_t count = 0;
  for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(d)) {
    const FloatVector ex = hn::Sub(hn::LoadU(d, dx + lane), hn::Set(d, x));
    const FloatVector ey = hn::Sub(hn::LoadU(d, dy + lane), hn::Set(d, y));
    count += hn::CountTrue(d, hn::Le(hn::MulAdd(ex, ex, hn::Mul(ey, ey)), hn::Set(d, largest)));
  }
  return count;
}

// Number and distances of those that agree with (x, y).
HWY_INLINE ConsistentMatches agreeing(const float* squared, const float* dx, const float* dy,
                                      std::size_t lanes, float x, float y, float largest) {
  const Floats d;
  FloatVector sum = hn::Zero(d);
  std::size_t count = 0;
  for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(d)) {
    const FloatVector ex = hn::Sub(hn::LoadU(d, dx + lane), hn::Set(d, x));
    const FloatVector ey = hn::Sub(hn::LoadU(d, dy + lane), hn::Set(d, y));
    const auto agree = hn::Le(hn::MulAdd(ex, ex, hn::Mul(ey, ey)), hn::Set(d, largest));
    const FloatVector certain = hn::Sub(hn::LoadU(d, squared + lane), hn::Set(d, underflow));
    sum = hn::Add(sum, hn::IfThenElseZero(agree, hn::Sqrt(hn::Max(certain, hn::Zero(d)))));
    count += hn::CountTrue(d, agree);
  }
  return {static_cast<int>(count), hn::GetLane(hn::SumOfLanes(d, sum)), false};
}

}  // namespace

ConsistentMatches consistent(const QueryLanes& lanes, const Region* candidates, std::size_t count,
                             EstimateWork& work) {
  const Floats d;
  const std::size_t padded = lanes.x.size();
  float* squared = work.numbers.data();
  float* dx = squared + padded;
  float* dy = dx + padded;
  work.x.resize(std::max(work.x.size(), count + lane_padding));
  work.y.resize(work.x.size());
  for (std::size_t j = 0; j < count; ++j) {
    work.x[j] = candidates[j].x;
    work.y[j] = candidates[j].y;
  }
  std::fill_n(work.x.data() + count, lane_padding, no_candidate);
  for (std::size_t lane = 0; lane < padded; lane += hn::Lanes(d)) {
    const Nearest found = nearest(lanes, lane, candidates, count, work);
    if (found.ambiguous) return {0, 0, true};
    hn::StoreU(found.least, d, squared + lane);
    hn::StoreU(found.dx, d, dx + lane);
    hn::StoreU(found.dy, d, dy + lane);
  }
  std::size_t most = 0;
  std::size_t common = 0;
  for (const std::size_t lane : lanes.order) {
    const std::size_t agree = supporters(dx, dy, padded, dx[lane], dy[lane], lanes.largest_squared_spread);
    const std::size_t support = squared[lane] < no_candidate ? agree : 0;
    common = support > most ? lane : common;
    most = std::max(most, support);
  }
  if (most == 0) return {};
  return agreeing(squared, dx, dy, padded, dx[common], dy[common], lanes.largest_squared_spread);
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
