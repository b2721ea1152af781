#include "channels.hpp"

#include "sailmap/hls/arithmetic.hpp"
#include "vectors.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "frontends/fixed/channels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sailmap::fixed::HWY_NAMESPACE {
namespace {

using Lanes = hn::RebindToUnsigned<Lanes16>;
using Vector = hn::Vec<Lanes>;

// The least s of a pixel with colour.
constexpr int least_colour_sum() {
  int s = 0;
  while (!hls::has_colour(s)) ++s;
  return s;
}

// colour_reciprocal of s, where s is at least least_colour_sum(): 1.5/s scaled, correctly rounded by the
// division to 24 bits and by the addition of 2^23 to an integer. That is the table's rounding for each s
// (tested): no quotient lies near enough to the middle between two integers.
HWY_INLINE hn::Vec<hn::CappedTag<float, 16>> reciprocal_bits(hn::Vec<Lanes32> s) {
  const hn::CappedTag<float, 16> d;
  constexpr auto numerator = static_cast<float>(3 << (formats::colour_reciprocal::fraction - 1));
  constexpr float integers_from = 0x1p23F;
  return hn::Add(hn::Div(hn::Set(d, numerator), hn::ConvertTo(d, s)), hn::Set(d, integers_from));
}

HWY_INLINE Vector reciprocals(Vector s) {
  const Lanes d;
  const Lanes32 d32;
  const auto pairs = hn::BitCast(d32, hn::Max(s, hn::Set(d, least_colour_sum())));
  const auto even = hn::BitCast(d32, reciprocal_bits(hn::And(pairs, hn::Set(d32, 0xffff))));
  const auto odd = hn::BitCast(d32, reciprocal_bits(hn::ShiftRight<16>(pairs)));
  const auto k = hn::OddEven(hn::BitCast(d, hn::ShiftLeft<16>(odd)), hn::BitCast(d, even));
  return hn::IfThenElseZero(hn::Gt(s, hn::Set(d, least_colour_sum() - 1)), k);
}

// hls::tuned_colour of `doubled` >= 0, less the bias: the product has 25 bits, its upper and lower 16 are
// computed apart.
HWY_INLINE void store_colour(Vector reciprocal, Vector doubled, Sample* to) {
  const Lanes d;
  const hn::RebindToSigned<Lanes> d_signed;
  constexpr int shift = formats::colour_reciprocal::fraction - formats::colour::fraction;
  static_assert(formats::colour::rounding == hls::Rounding::rnd);
  const auto high = hn::ShiftLeft<16 - shift>(hn::MulHigh(reciprocal, doubled));
  // AverageRound(v, 0) is v/2, rounded up: one bit more than is wanted is left before.
  const auto low = hn::AverageRound(hn::ShiftRight<shift - 1>(hn::Mul(reciprocal, doubled)), hn::Zero(d));
  const auto biased = hn::Xor(hn::Add(high, low), hn::Set(d, static_cast<std::uint16_t>(bias)));
  hn::StoreU(hn::BitCast(d_signed, biased), d_signed, to);
}

template <ChannelOrder Order>
HWY_INLINE void pixels(const std::uint8_t* from, int x, const std::array<Sample*, channel_count>& rows) {
  const Lanes d;
  const hn::Rebind<std::uint8_t, Lanes> d8;
  hn::Vec<decltype(d8)> first;
  hn::Vec<decltype(d8)> second;
  hn::Vec<decltype(d8)> third;
  hn::LoadInterleaved3(d8, from + 3 * static_cast<std::ptrdiff_t>(x), first, second, third);
  const auto r = hn::PromoteTo(d, Order == ChannelOrder::rgb ? first : third);
  const auto g = hn::PromoteTo(d, second);
  const auto b = hn::PromoteTo(d, Order == ChannelOrder::rgb ? third : first);
  const auto s = hn::Add(hn::Add(r, g), b);
  const hn::RebindToSigned<Lanes> d_signed;
  hn::StoreU(hn::Sub(hn::BitCast(d_signed, s), hn::Set(d_signed, grey_bias)), d_signed, rows[intensity] + x);
  const auto k = reciprocals(s);
  // 2r - g - b = 3r - s; a saturated difference is cut at 0.
  const auto doubled = [&](Vector v) HWY_ATTR { return hn::SaturatedSub(hn::Add(hn::Add(v, v), v), s); };
  store_colour(k, doubled(r), rows[red] + x);
  store_colour(k, doubled(g), rows[green] + x);
  store_colour(k, doubled(b), rows[blue] + x);
  const auto yellowness = hn::SaturatedSub(hn::Min(r, g), b);
  store_colour(k, hn::Add(yellowness, yellowness), rows[yellow] + x);
}

// The last vector ends with the row and may overlap the one before: nothing beyond the image is read.
template <ChannelOrder Order>
HWY_INLINE void row(const std::uint8_t* from, int width, const std::array<Sample*, channel_count>& rows) {
  const int step = lanes_of(Lanes());
  for (int x = 0; x < width - step; x += step) pixels<Order>(from, x, rows);
  pixels<Order>(from, width - step, rows);
}

void channel_row(const std::uint8_t* from, int width, ChannelOrder order,
                 const std::array<Sample*, channel_count>& rows) {
  if (order == ChannelOrder::rgb) {
    row<ChannelOrder::rgb>(from, width, rows);
  } else {
    row<ChannelOrder::bgr>(from, width, rows);
  }
}

}  // namespace
}  // namespace sailmap::fixed::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sailmap::fixed {

HWY_EXPORT(channel_row);

void channels(const ImageView& image, int y, const std::array<Sample*, channel_count>& rows) {
  HWY_DYNAMIC_DISPATCH(channel_row)
  (image.data + y * image.stride, image.width, image.order, rows);
}

}  // namespace sailmap::fixed
#endif
