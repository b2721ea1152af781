#include "orientation.hpp"

#include "sailmap/hls/arithmetic.hpp"
#include "sailmap/hls/gabor_coefficients.hpp"
#include "sailmap/hls/ranges.hpp"
#include "vectors.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "frontends/fixed/orientation.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace sailmap::fixed::HWY_NAMESPACE {
namespace {

namespace gabor = hls::gabor;
namespace ranges = hls::ranges;

constexpr int taps = gabor::taps;
constexpr int radius = hls::geometry::gabor_radius;
constexpr std::size_t pairs = (taps + 1) / 2;
constexpr int border = 16;  // beyond which no column is looked at
using Planes = std::array<EnergyPlane*, hls::geometry::orientation_maps>;

// A filter's taps two by two, the last alone.
struct Taps {
  hn::Vec<Lanes16> weights[pairs];
  int sum;

  explicit Taps(const int (&filter)[taps]) : sum(gabor::sum(filter)) {
    for (std::size_t k = 0; k < pairs; ++k) {
      weights[k] = pair_of_weights(filter[2 * k], 2 * k + 1 < taps ? filter[2 * k + 1] : 0);
    }
  }
};

// --- Vertical ---

// Nine rows, interleaved two by two and separated in the lower and upper halves of blocks.
struct RowPairs {
  hn::Vec<Lanes16> lower[pairs];
  hn::Vec<Lanes16> upper[pairs];

  HWY_INLINE RowPairs(const Sample* const (&rows)[taps], int x) {
    const Lanes16 d;
    for (std::size_t k = 0; k < pairs; ++k) {
      const auto a = hn::LoadU(d, rows[2 * k] + x);
      const auto b = 2 * k + 1 < taps ? hn::LoadU(d, rows[2 * k + 1] + x) : hn::Zero(d);
      lower[k] = hn::InterleaveLower(d, a, b);
      upper[k] = hn::InterleaveUpper(d, a, b);
    }
  }
};

// With the bias or without it, sums stay within 32 bits.
static_assert(bias * ranges::max_of(ranges::absolute_sum(gabor::E), ranges::absolute_sum(gabor::G)) +
                      bias * ranges::absolute_sum(gabor::C) <
                  ranges::two_to(31) &&
              bias * ranges::max_of(ranges::absolute_sum(gabor::O), ranges::absolute_sum(gabor::S)) <
                  ranges::two_to(30));

// hls::gabor_column of each sum, the bias taken back.
HWY_INLINE void store_columns(const RowPairs& rows, const Taps& filter, std::int16_t* out) {
  const Lanes16 d;
  const auto unbias = hn::Set(Lanes32(), bias * filter.sum);
  using Sum = hls::Exactly<31, formats::intensity::fraction, hls::Sign::is_signed>;
  const auto column = [&](hn::Vec<Lanes32> sum) HWY_ATTR {
    return requantise_lanes<Sum, formats::gabor_column>(hn::Add(sum, unbias));
  };
  // Packs by blocks, as interleaving took them apart.
  hn::StoreU(hn::ReorderDemote2To(d, column(sum_of_pairs(rows.lower, filter.weights)),
                                  column(sum_of_pairs(rows.upper, filter.weights))),
             d, out);
}

struct Filters {
  Taps even, odd, cosine, sine, gauss;

  // A constructor that the compiler makes is made for no target.
  HWY_INLINE Filters() : even(gabor::E), odd(gabor::O), cosine(gabor::C), sine(gabor::S), gauss(gabor::G) {}
};

HWY_INLINE void vertical(const PaddedPlane<Sample>& level, int y, const Filters& filters,
                         PaddedPlane<std::int16_t>& columns) {
  const Sample* rows[taps];
  for (int k = 0; k < taps; ++k) rows[k] = level.clamped_row(y + k - radius);
  for (int x = -border; x < level.width() + radius; x += lanes_of(Lanes16())) {
    const RowPairs row_pairs(rows, x);
    store_columns(row_pairs, filters.even, columns.row(Orientation::even) + x);
    store_columns(row_pairs, filters.odd, columns.row(Orientation::odd) + x);
    store_columns(row_pairs, filters.cosine, columns.row(Orientation::cosine) + x);
    store_columns(row_pairs, filters.sine, columns.row(Orientation::sine) + x);
    store_columns(row_pairs, filters.gauss, columns.row(Orientation::gauss) + x);
  }
}

// --- Horizontal ---

// Nine columns around every second one from x.
struct ColumnPairs {
  hn::Vec<Lanes16> columns[pairs];

  HWY_INLINE ColumnPairs(const std::int16_t* row, int x) {
    const Lanes16 d;
    for (std::size_t k = 0; k < pairs; ++k)
      columns[k] = hn::LoadU(d, row + x - radius + static_cast<std::ptrdiff_t>(2 * k));
  }
  HWY_INLINE hn::Vec<Lanes32> sum(const Taps& filter) const { return sum_of_pairs(columns, filter.weights); }
};

HWY_INLINE hn::Vec<Words32> response(hn::Vec<Lanes32> sum) {
  using Sum = hls::Exactly<29, formats::gabor_column::fraction>;
  return requantise_lanes<Sum, formats::gabor_response>(hn::BitCast(Words32(), hn::Abs(sum)));
}

// hls::gabor_energy. Products have 35 bits: the responses are split in two, and what the lower parts carry
// to the upper is added there; the last bits of the sum only decide the rounding.
template <int Index>
HWY_INLINE hn::Vec<Lanes32> energy(hn::Vec<Lanes32> even_sum, hn::Vec<Lanes32> odd_sum) {
  constexpr int lower_bits = formats::gabor_response::word / 2;
  constexpr int shift =
      formats::gabor_response::fraction + formats::gabor_scale::fraction - formats::gabor_energy::fraction;
  static_assert(formats::gabor_energy::rounding == hls::Rounding::rnd);
  static_assert(shift > lower_bits &&
                formats::gabor_response::word - lower_bits + formats::gabor_scale::word + 1 <= 31);
  constexpr std::uint32_t even_factor = hls::gabor_scale(gabor::even_scale(Index));
  constexpr std::uint32_t odd_factor = hls::gabor_scale(gabor::odd_scale(Index));
  const Words32 d;
  const auto even = response(even_sum);
  const auto odd = response(odd_sum);
  const auto even_scale = hn::Set(d, even_factor);
  const auto odd_scale = hn::Set(d, odd_factor);
  const auto lower_mask = hn::Set(d, (1U << lower_bits) - 1);
  const auto lower =
      hn::Add(hn::Mul(hn::And(even, lower_mask), even_scale), hn::Mul(hn::And(odd, lower_mask), odd_scale));
  const auto upper = hn::Add(hn::Mul(hn::ShiftRight<lower_bits>(even), even_scale),
                             hn::Mul(hn::ShiftRight<lower_bits>(odd), odd_scale));
  const auto carried = hn::ShiftRight<lower_bits>(hn::Add(lower, hn::Set(d, 1U << (shift - 1))));
  return hn::BitCast(Lanes32(), hn::ShiftRight<shift - lower_bits>(hn::Add(upper, carried)));
}

struct Energies {
  hn::Vec<Lanes32> at[hls::geometry::orientation_maps];
};

// Of every second pixel from x. Sums are named filter along x, filter along y.
HWY_INLINE Energies energies_at(const PaddedPlane<std::int16_t>& columns, int x, const Filters& filters) {
  const ColumnPairs gauss(columns.row(Orientation::gauss), x);
  const ColumnPairs cosine(columns.row(Orientation::cosine), x);
  const ColumnPairs sine(columns.row(Orientation::sine), x);
  const auto gg = gauss.sum(filters.gauss);
  const auto cc_gg = hn::Sub(cosine.sum(filters.cosine), gg);
  const auto ss = sine.sum(filters.sine);
  const auto sc = cosine.sum(filters.sine);
  const auto cs = sine.sum(filters.cosine);
  Energies out;
  out.at[0] = energy<0>(gauss.sum(filters.even), gauss.sum(filters.odd));
  out.at[1] = energy<1>(hn::Sub(cc_gg, ss), hn::Add(sc, cs));
  out.at[2] = energy<2>(ColumnPairs(columns.row(Orientation::even), x).sum(filters.gauss),
                        ColumnPairs(columns.row(Orientation::odd), x).sum(filters.gauss));
  out.at[3] = energy<3>(hn::Add(cc_gg, ss), hn::Sub(cs, sc));
  return out;
}

HWY_INLINE void horizontal(const PaddedPlane<std::int16_t>& columns, int y, const Filters& filters,
                           const Planes& energies) {
  const Lanes32 d;
  for (int x = 0; x < columns.width(); x += lanes_of(Lanes16())) {
    const Energies even = energies_at(columns, x, filters);
    const Energies odd = energies_at(columns, x + 1, filters);
    for (std::size_t i = 0; i < energies.size(); ++i) {
      hn::StoreInterleaved2(even.at[i], odd.at[i], d, energies[i]->row(y) + x);
    }
  }
}

void orientation(const PaddedPlane<Sample>& level, PaddedPlane<std::int16_t>& columns,
                 const Planes& energies) {
  const Filters filters;
  for (int y = 0; y < level.height(); ++y) {
    vertical(level, y, filters, columns);
    horizontal(columns, y, filters, energies);
  }
}

}  // namespace
}  // namespace sailmap::fixed::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sailmap::fixed {

HWY_EXPORT(orientation);

void Orientation::compute(const PaddedPlane<Sample>& level,
                          const std::array<EnergyPlane*, hls::geometry::orientation_maps>& energies) {
  columns_.resize(level.width(), filters);
  for (EnergyPlane* plane : energies) plane->resize(level.width(), level.height());
  HWY_DYNAMIC_DISPATCH(orientation)(level, columns_, energies);
}

}  // namespace sailmap::fixed
#endif
