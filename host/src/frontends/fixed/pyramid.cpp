#include "pyramid.hpp"

#include "channels.hpp"
#include "sailmap/hls/arithmetic.hpp"
#include "vectors.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "frontends/fixed/pyramid.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sailmap::fixed::HWY_NAMESPACE {
namespace {

// The horizontal filter [1 4 6 4 1] at every second sample.
struct Binomial {
  hn::Vec<Lanes16> weights[3];

  // A constructor that the compiler makes is made for no target.
  HWY_INLINE Binomial() : weights{pair_of_weights(1, 4), pair_of_weights(6, 4), pair_of_weights(1, 0)} {}

  // Lane i: around sample 2 (x + i).
  HWY_INLINE hn::Vec<Lanes32> at(const Sample* row, int x) const {
    const Lanes16 d;
    const Sample* centre = row + 2 * static_cast<std::ptrdiff_t>(x);
    const hn::Vec<Lanes16> samples[3] = {hn::LoadU(d, centre - 2), hn::LoadU(d, centre),
                                         hn::LoadU(d, centre + 2)};
    return sum_of_pairs(samples, weights);
  }
};

// The 5x5 sum, weights adding up to 256 and both sides with their bias, to a sample.
template <class From, class To>
HWY_INLINE void store_reduced(hn::Vec<Lanes32> sum, Sample* to) {
  const HalfLanes16 d;
  using Sum = hls::Exactly<31, From::fraction + 8, hls::Sign::is_signed>;
  hn::StoreU(hn::DemoteTo(d, requantise_lanes<Sum, To>(sum)), d, to);
}

// Row 0 stands for those above it as well, whose weights in the first row's sum are 1 and 4.
void start(const Sample* row, int width, std::int32_t* next) {
  const Lanes32 d;
  const Binomial binomial;
  for (int x = 0; x < width; x += lanes_of(d)) {
    hn::StoreU(hn::Mul(binomial.at(row, x), hn::Set(d, 5)), d, next + x);
  }
}

template <class From, class To>
HWY_INLINE void pair(const Sample* even, const Sample* odd, int width, std::int32_t* current,
                     std::int32_t* next, Sample* out) {
  const Lanes32 d;
  const Binomial binomial;
  for (int x = 0; x < width; x += lanes_of(d)) {
    const auto e = binomial.at(even, x);
    const auto o = binomial.at(odd, x);
    store_reduced<From, To>(hn::Add(hn::LoadU(d, current + x), e), out + x);
    const auto e_4o = hn::Add(e, hn::ShiftLeft<2>(o));
    const auto e_5 = hn::Add(e, hn::ShiftLeft<2>(e));
    hn::StoreU(hn::Add(hn::LoadU(d, next + x), hn::Add(e_4o, e_5)), d, current + x);
    hn::StoreU(e_4o, d, next + x);
  }
}

template <class From, class To>
HWY_INLINE void last(const Sample* row, int width, const std::int32_t* current, Sample* out) {
  const Lanes32 d;
  const Binomial binomial;
  for (int x = 0; x < width; x += lanes_of(d)) {
    store_reduced<From, To>(hn::Add(hn::LoadU(d, current + x), binomial.at(row, x)), out + x);
  }
}

void grey_pair(const Sample* even, const Sample* odd, int width, std::int32_t* current, std::int32_t* next,
               Sample* out) {
  pair<formats::grey_sum, formats::intensity>(even, odd, width, current, next, out);
}
void grey_last(const Sample* row, int width, const std::int32_t* current, Sample* out) {
  last<formats::grey_sum, formats::intensity>(row, width, current, out);
}
// Intensity and colour keep their format from level to level.
void sample_pair(const Sample* even, const Sample* odd, int width, std::int32_t* current, std::int32_t* next,
                 Sample* out) {
  pair<formats::colour, formats::colour>(even, odd, width, current, next, out);
}
void sample_last(const Sample* row, int width, const std::int32_t* current, Sample* out) {
  last<formats::colour, formats::colour>(row, width, current, out);
}

}  // namespace
}  // namespace sailmap::fixed::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sailmap::fixed {

namespace geometry = hls::geometry;

HWY_EXPORT(start);
HWY_EXPORT(grey_pair);
HWY_EXPORT(grey_last);
HWY_EXPORT(sample_pair);
HWY_EXPORT(sample_last);

void Pyramid::resize(int width, int height) {
  for (int l = 0; l <= geometry::top_level; ++l) {
    Level& level = levels_[static_cast<std::size_t>(l)];
    level.width = geometry::level_side(width, l);
    level.height = geometry::level_side(height, l);
    for (auto& plane : level.planes) {
      plane.resize(level.width, l < geometry::base_level ? 2 : level.height);
    }
    for (auto& reduction : level.reductions) reduction.sums.resize(geometry::half(level.width), 2);
  }
}

Sample* Pyramid::row(int level, std::size_t channel, int y) {
  return levels_[static_cast<std::size_t>(level)].planes[channel].row(level < geometry::base_level ? y % 2
                                                                                                   : y);
}

void Pyramid::compute(const ImageView& image) {
  resize(image.width, image.height);
  for (int y = 0; y < image.height; ++y) {
    std::array<Sample*, channel_count> rows{};
    for (std::size_t c = 0; c < rows.size(); ++c) rows[c] = row(0, c, y);
    channels(image, y, rows);
    row_is_complete(0, y);
  }
}

void Pyramid::row_is_complete(int l, int y) {
  const Level& level = levels_[static_cast<std::size_t>(l)];
  for (std::size_t c = 0; c < channel_count; ++c) {
    replicate_edges(row(l, c, y), level.width, l < geometry::base_level ? 2 : border);
  }
  if (l == geometry::top_level) return;
  const bool is_last = y == level.height - 1;
  if (y % 2 != 0) {
    reduce_pair(l, y - 1, y);
  } else if (is_last) {
    reduce_pair(l, y, y);
  }
  if (is_last) reduce_last(l, y);
}

void Pyramid::reduce_pair(int l, int even_y, int odd_y) {
  Level& level = levels_[static_cast<std::size_t>(l)];
  const int width = geometry::half(level.width);
  const int out_y = even_y / 2 - 1;
  for (std::size_t c = 0; c < channel_count; ++c) {
    auto& sums = level.reductions[c].sums;
    const Sample* even = row(l, c, even_y);
    if (out_y < 0) HWY_DYNAMIC_DISPATCH(start)(even, width, sums.row(1));
    const auto pair =
        l == 0 && c == intensity ? HWY_DYNAMIC_DISPATCH(grey_pair) : HWY_DYNAMIC_DISPATCH(sample_pair);
    // What comes out of the first pair belongs to no row; row 0 is written again by the second.
    pair(even, row(l, c, odd_y), width, sums.row(0), sums.row(1), row(l + 1, c, std::max(out_y, 0)));
  }
  if (out_y >= 0) row_is_complete(l + 1, out_y);
}

void Pyramid::reduce_last(int l, int y) {
  Level& level = levels_[static_cast<std::size_t>(l)];
  const int out_y = y / 2;
  for (std::size_t c = 0; c < channel_count; ++c) {
    const auto last =
        l == 0 && c == intensity ? HWY_DYNAMIC_DISPATCH(grey_last) : HWY_DYNAMIC_DISPATCH(sample_last);
    last(row(l, c, y), geometry::half(level.width), level.reductions[c].sums.row(0), row(l + 1, c, out_y));
  }
  row_is_complete(l + 1, out_y);
}

}  // namespace sailmap::fixed
#endif
