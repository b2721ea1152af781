#include "differing_bits.hpp"

#include <bit>

// The instruction set that counts bits in whole vectors is worth the code here.
#define HWY_WANT_AVX3_DL
#include "simd/sized_vectors.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "context/differing_bits.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sailmap::context {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void differing(const std::uint64_t* words, std::uint32_t which, const BitRows& rows, std::uint64_t* counts) {
  const hn::CappedTag<std::uint64_t, BitRows::granule> d;
  for (std::size_t lane = 0; lane < rows.lanes; lane += hn::Lanes(d)) {
    auto count = hn::Zero(d);
    for (std::uint32_t left = which; left != 0; left &= left - 1) {
      const auto word = static_cast<std::size_t>(std::countr_zero(left));
      const std::size_t at = word * rows.lanes + lane;
      const auto differ = hn::Xor(hn::Set(d, words[word]), hn::LoadU(d, rows.words.data() + at));
      count = hn::Add(count, hn::PopulationCount(hn::And(differ, hn::LoadU(d, rows.masks.data() + at))));
    }
    hn::StoreU(count, d, counts + lane);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace sailmap::context
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sailmap::context {

HWY_EXPORT(differing);

void differing_bits(const std::uint64_t* words, std::uint32_t which, const BitRows& rows,
                    std::uint64_t* counts) {
  HWY_DYNAMIC_DISPATCH(differing)(words, which, rows, counts);
}

}  // namespace sailmap::context
#endif  // HWY_ONCE
