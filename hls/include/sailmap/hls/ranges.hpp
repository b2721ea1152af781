// Range analysis: the largest raw value at every named point, each derived from those before it, for all
// images of all sizes; and the proof that each format of formats.hpp holds it with no bit to spare.
//
// A filter's largest output is the sum of its positive taps times the largest input; a rounded value is at
// most its bound rounded, since rounding is monotonic. The tests reach each bound within a bit with extreme
// images.
#pragma once

#include <cstdint>

#include "sailmap/hls/arithmetic.hpp"
#include "sailmap/hls/formats.hpp"
#include "sailmap/hls/gabor_coefficients.hpp"
#include "sailmap/hls/geometry.hpp"

namespace sailmap {
namespace hls {
namespace ranges {

constexpr std::int64_t max_of(std::int64_t a, std::int64_t b) { return a > b ? a : b; }

// `value` with From fraction bits, rounded as F rounds, in a word that cannot overflow.
template <class F, int From>
constexpr std::int64_t rounded(std::int64_t value) {
  using Wide = Format<63, F::fraction, Sign::is_signed, F::rounding>;
  return requantise<Exactly<50, From, Sign::is_signed>, Wide>(value);
}

// --- Section 2 ---

constexpr std::int64_t grey_sum = std::int64_t{3} * 255;

// The least s with colour has the largest reciprocal.
constexpr std::int64_t largest_reciprocal() {
  std::int64_t largest = 0;
  for (int s = 0; s <= 765; ++s) largest = max_of(largest, colour_reciprocal(s));
  return largest;
}
constexpr std::int64_t colour_reciprocal_entry = largest_reciprocal();

// At a given s the most is 2r - g - b with r as large as it can be, so g + b = s - r.
constexpr std::int64_t largest_colour_product() {
  std::int64_t largest = 0;
  for (int s = 0; s <= 765; ++s) {
    const int r = s < 255 ? s : 255;
    largest = max_of(largest, colour_reciprocal(s) * std::int64_t{3 * r - s});
  }
  return largest;
}
constexpr std::int64_t colour =
    rounded<formats::colour, formats::colour_reciprocal::fraction>(largest_colour_product());

// --- Section 3: weights that sum to 1 ---

constexpr std::int64_t intensity = rounded<formats::intensity, formats::grey_sum::fraction>(grey_sum);

// --- Section 4: the centre at its largest, all else 0 ---

constexpr std::int64_t area_of(std::int64_t radius) { return (2 * radius + 1) * (2 * radius + 1); }
constexpr std::int64_t small_area = area_of(geometry::surround_radius_small);
constexpr std::int64_t large_area = area_of(geometry::surround_radius_large);
static_assert(small_area == 49 && large_area == 225, "contrast() has these in it");

constexpr std::int64_t contrast_sum_of(std::int64_t level) {
  return 14 * (small_area - 1) * level + 3 * (large_area - 1) * level;
}
constexpr std::int64_t intensity_contrast =
    rounded<formats::intensity_contrast, formats::intensity::fraction + 5>(contrast_sum_of(intensity));
constexpr std::int64_t colour_contrast =
    rounded<formats::colour_contrast, formats::colour::fraction + 5>(contrast_sum_of(colour));

// --- Section 5 ---

constexpr std::int64_t largest_positive_sum() {
  return max_of(max_of(gabor::positive_sum(gabor::E), gabor::positive_sum(gabor::O)),
                max_of(gabor::positive_sum(gabor::C),
                       max_of(gabor::positive_sum(gabor::S), gabor::positive_sum(gabor::G))));
}
constexpr std::int64_t largest_negative_sum() {
  return max_of(max_of(gabor::negative_sum(gabor::E), gabor::negative_sum(gabor::O)),
                max_of(gabor::negative_sum(gabor::C), gabor::negative_sum(gabor::S)));
}
constexpr std::int64_t gabor_column_most =
    rounded<formats::gabor_column, formats::intensity::fraction>(largest_positive_sum() * intensity);
constexpr std::int64_t gabor_column_least =
    rounded<formats::gabor_column, formats::intensity::fraction>(-largest_negative_sum() * intensity);

// The horizontal filters of one window, in absolute values: what half a unit of rounding in every column
// becomes.
constexpr std::int64_t absolute_sum(const int (&filter)[gabor::taps]) {
  return gabor::positive_sum(filter) + gabor::negative_sum(filter);
}
constexpr std::int64_t column_weight(int orientation, bool even) {
  return orientation == 0   ? absolute_sum(even ? gabor::E : gabor::O)
         : orientation == 2 ? absolute_sum(gabor::G)
         : even             ? absolute_sum(gabor::C) + absolute_sum(gabor::S) + absolute_sum(gabor::G)
                            : absolute_sum(gabor::C) + absolute_sum(gabor::S);
}

// A window free of DC has positive taps of half its sum of absolute values.
constexpr std::int64_t window_sum(int orientation, bool even) {
  return ((even ? gabor::even_scale(orientation) : gabor::odd_scale(orientation)) / 2 * intensity >>
          (formats::intensity::fraction - formats::gabor_column::fraction)) +
         column_weight(orientation, even) / 2 + 1;
}
constexpr std::int64_t largest_window_sum() {
  std::int64_t largest = 0;
  for (int i = 0; i < geometry::orientation_maps; ++i) {
    largest = max_of(largest, max_of(window_sum(i, true), window_sum(i, false)));
  }
  return largest;
}
constexpr std::int64_t response_of(std::int64_t sum) {
  return rounded<formats::gabor_response, formats::gabor_column::fraction>(sum);
}

constexpr std::int64_t largest_scale() {
  std::int64_t largest = 0;
  for (int i = 0; i < geometry::orientation_maps; ++i) {
    largest = max_of(largest, max_of(gabor_scale(gabor::even_scale(i)), gabor_scale(gabor::odd_scale(i))));
  }
  return largest;
}

constexpr std::int64_t energy_product(int orientation) {
  return response_of(window_sum(orientation, true)) * gabor_scale(gabor::even_scale(orientation)) +
         response_of(window_sum(orientation, false)) * gabor_scale(gabor::odd_scale(orientation));
}
constexpr std::int64_t largest_energy_product() {
  std::int64_t largest = 0;
  for (int i = 0; i < geometry::orientation_maps; ++i) largest = max_of(largest, energy_product(i));
  return largest;
}
constexpr std::int64_t gabor_energy =
    rounded<formats::gabor_energy, formats::gabor_response::fraction + formats::gabor_scale::fraction>(
        largest_energy_product());

// --- Section 6: every level at its largest ---

template <class Level, class Partial>
constexpr std::int64_t partial_of(std::int64_t level) {
  return rounded<Partial, Level::fraction>(2 * level);
}
template <class Level, class Partial>
constexpr std::int64_t sum_of(std::int64_t level) {
  return 4 * partial_of<Level, Partial>(level) + 2 * level;
}
constexpr std::int64_t intensity_partial =
    partial_of<formats::intensity_contrast, formats::intensity_partial>(intensity_contrast);
constexpr std::int64_t colour_partial =
    partial_of<formats::colour_contrast, formats::colour_partial>(colour_contrast);
constexpr std::int64_t orientation_partial =
    partial_of<formats::gabor_energy, formats::orientation_partial>(gabor_energy);
constexpr std::int64_t intensity_sum =
    sum_of<formats::intensity_contrast, formats::intensity_partial>(intensity_contrast);
constexpr std::int64_t colour_sum =
    sum_of<formats::colour_contrast, formats::colour_partial>(colour_contrast);
constexpr std::int64_t orientation_sum =
    sum_of<formats::gabor_energy, formats::orientation_partial>(gabor_energy);
constexpr std::int64_t intensity_feature =
    rounded<formats::intensity_feature, formats::intensity_sum::fraction>(intensity_sum);
constexpr std::int64_t colour_feature =
    rounded<formats::colour_feature, formats::colour_sum::fraction>(colour_sum);
constexpr std::int64_t orientation_feature =
    rounded<formats::orientation_feature, formats::orientation_sum::fraction>(orientation_sum);

// --- Section 7 ---

// A local maximum is > its neighbours before it in raster order and >= those after: two are never adjacent,
// so no two share one of the 2x2 squares that tile the map.
constexpr std::int64_t maxima_count =
    std::int64_t{geometry::half(geometry::base_side(geometry::max_image_side))} *
    geometry::half(geometry::base_side(geometry::max_image_side));
// sqrt(m) of m just below a power of four.
constexpr std::int64_t square_root =
    isqrt(((std::uint64_t{1} << formats::maxima_count::word) - 1) << (36 - formats::maxima_count::word));
// The largest gain, and the only one that saturates: a lone peak that is a power of two.
constexpr std::int64_t gain_mantissa = hls::gain(1, 1).mantissa;
// value * mantissa * 16 <= max * mantissa * 16 < 2^shift * 2^20, since mantissa < 2^48 / (max sqrt(m)) scaled
// likewise.
constexpr std::int64_t normalised = (std::int64_t{1} << formats::normalised::fraction) - 1;
constexpr std::int64_t intensity_conspicuity_sum = geometry::intensity_maps * normalised;
constexpr std::int64_t colour_conspicuity_sum = geometry::colour_maps * normalised;
constexpr std::int64_t orientation_conspicuity_sum = geometry::orientation_maps * normalised;
template <class F>
constexpr std::int64_t sum_of_normalised(int maps) {
  return rounded<F, formats::normalised::fraction>(maps * normalised);
}
constexpr std::int64_t intensity_conspicuity =
    sum_of_normalised<formats::intensity_conspicuity>(geometry::intensity_maps);
constexpr std::int64_t colour_conspicuity =
    sum_of_normalised<formats::colour_conspicuity>(geometry::colour_maps);
constexpr std::int64_t orientation_conspicuity =
    sum_of_normalised<formats::orientation_conspicuity>(geometry::orientation_maps);
constexpr std::int64_t saliency = sum_of_normalised<formats::saliency>(geometry::conspicuity_maps);

// --- The proof ---

// Held, and not by one bit less.
template <class F>
constexpr bool holds_tightly(std::int64_t largest) {
  return largest <= F::max_raw() && largest > F::max_raw() / 2;
}

static_assert(holds_tightly<formats::grey_sum>(grey_sum), "range");
static_assert(holds_tightly<formats::colour_reciprocal>(colour_reciprocal_entry), "range");
static_assert(holds_tightly<formats::colour>(colour), "range");
static_assert(holds_tightly<formats::intensity>(intensity), "range");
static_assert(holds_tightly<formats::intensity_box_small>(small_area * intensity), "range");
static_assert(holds_tightly<formats::intensity_box_large>(large_area * intensity), "range");
static_assert(holds_tightly<formats::colour_box_small>(small_area * colour), "range");
static_assert(holds_tightly<formats::colour_box_large>(large_area * colour), "range");
static_assert(holds_tightly<formats::intensity_contrast>(intensity_contrast), "range");
static_assert(holds_tightly<formats::colour_contrast>(colour_contrast), "range");
static_assert(holds_tightly<formats::gabor_column>(gabor_column_most), "range");
static_assert(holds_tightly<formats::gabor_response>(response_of(largest_window_sum())), "range");
static_assert(holds_tightly<formats::gabor_scale>(largest_scale()), "range");
static_assert(holds_tightly<formats::gabor_energy>(gabor_energy), "range");
static_assert(holds_tightly<formats::intensity_partial>(intensity_partial), "range");
static_assert(holds_tightly<formats::colour_partial>(colour_partial), "range");
static_assert(holds_tightly<formats::orientation_partial>(orientation_partial), "range");
static_assert(holds_tightly<formats::intensity_sum>(intensity_sum), "range");
static_assert(holds_tightly<formats::colour_sum>(colour_sum), "range");
static_assert(holds_tightly<formats::orientation_sum>(orientation_sum), "range");
static_assert(holds_tightly<formats::intensity_feature>(intensity_feature), "range");
static_assert(holds_tightly<formats::colour_feature>(colour_feature), "range");
static_assert(holds_tightly<formats::orientation_feature>(orientation_feature), "range");
static_assert(holds_tightly<formats::maxima_count>(maxima_count), "range");
static_assert(holds_tightly<formats::square_root>(square_root), "range");
static_assert(holds_tightly<formats::gain>(gain_mantissa), "range");
static_assert(holds_tightly<formats::normalised>(normalised), "range");
static_assert(holds_tightly<formats::intensity_conspicuity_sum>(intensity_conspicuity_sum), "range");
static_assert(holds_tightly<formats::colour_conspicuity_sum>(colour_conspicuity_sum), "range");
static_assert(holds_tightly<formats::orientation_conspicuity_sum>(orientation_conspicuity_sum), "range");
static_assert(holds_tightly<formats::intensity_conspicuity>(intensity_conspicuity), "range");
static_assert(holds_tightly<formats::colour_conspicuity>(colour_conspicuity), "range");
static_assert(holds_tightly<formats::orientation_conspicuity>(orientation_conspicuity), "range");
static_assert(holds_tightly<formats::normalised_conspicuity>(normalised), "range");
static_assert(holds_tightly<formats::saliency>(saliency), "range");
static_assert(gabor_column_least >= formats::gabor_column::min_raw(), "range");

// The integers between the points fit the 32 bits that arithmetic.hpp computes them in.
constexpr std::int64_t two_to(int bits) { return std::int64_t{1} << bits; }
static_assert(largest_colour_product() < two_to(25), "tuned_colour");
static_assert(256 * max_of(intensity, colour) < two_to(24), "reduce");
static_assert(contrast_sum_of(max_of(intensity, colour)) < two_to(26), "contrast_sum");
static_assert(max_of(largest_positive_sum(), largest_negative_sum()) * intensity < two_to(30),
              "gabor_column");
static_assert(largest_window_sum() < two_to(29), "gabor_response");
static_assert(largest_energy_product() < two_to(35), "gabor_energy");
static_assert(8 * max_of(max_of(intensity_contrast, colour_contrast), gabor_energy) < two_to(21),
              "partial_sum");

}  // namespace ranges
}  // namespace hls
}  // namespace sailmap
