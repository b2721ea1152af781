#include "local_maxima.hpp"

#include "vectors.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "frontends/fixed/local_maxima.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sailmap::fixed::HWY_NAMESPACE {
namespace {

// Above the four neighbours already scanned, not below the other four.
HWY_INLINE auto is_maximum(hn::Vec<Lanes32> v, const std::int32_t* above, const std::int32_t* here,
                           const std::int32_t* below) {
  const Lanes32 d;
  const auto before = hn::Max(hn::Max(hn::LoadU(d, above - 1), hn::LoadU(d, above)),
                              hn::Max(hn::LoadU(d, above + 1), hn::LoadU(d, here - 1)));
  const auto after = hn::Max(hn::Max(hn::LoadU(d, below - 1), hn::LoadU(d, below)),
                             hn::Max(hn::LoadU(d, below + 1), hn::LoadU(d, here + 1)));
  return hn::AndNot(hn::Gt(after, v), hn::Gt(v, before));
}

// Most of a map is below half its maximum: whole vectors are passed by. Beyond a row's end all is -1.
std::uint32_t local_maxima(const SumPlane& sums, std::int32_t least) {
  const Lanes32 d;
  const int step = lanes_of(d);
  const auto limit = hn::Set(d, least - 1);
  std::size_t count = 0;
  for (int y = 0; y < sums.height(); ++y) {
    const std::int32_t* above = sums.row(y - 1);
    const std::int32_t* here = sums.row(y);
    const std::int32_t* below = sums.row(y + 1);
    for (int x = 0; x < sums.width(); x += step) {
      const auto v = hn::LoadU(d, here + x);
      const auto high = hn::Gt(v, limit);
      if (hn::AllFalse(d, high)) continue;
      count += hn::CountTrue(d, hn::And(high, is_maximum(v, above + x, here + x, below + x)));
    }
  }
  return static_cast<std::uint32_t>(count);
}

}  // namespace
}  // namespace sailmap::fixed::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sailmap::fixed {

HWY_EXPORT(local_maxima);

std::uint32_t count_local_maxima(const SumPlane& sums, std::int32_t least) {
  return HWY_DYNAMIC_DISPATCH(local_maxima)(sums, least);
}

}  // namespace sailmap::fixed
#endif
