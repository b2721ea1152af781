// Range analysis of the signature (see ranges.hpp): the largest raw value at each of its points, and the
// proof that each format holds it with no bit to spare.
#pragma once

#include <cstdint>

#include "sailmap/hls/formats.hpp"
#include "sailmap/hls/ranges.hpp"
#include "sailmap/hls/signature_arithmetic.hpp"
#include "sailmap/hls/signature_record.hpp"

namespace sailmap {
namespace hls {
namespace ranges {

constexpr std::int64_t region_area =
    std::int64_t{signature_record::max_box_side} * signature_record::max_box_side;

// Every X~ is below 1: normalise() in ranges.hpp.
constexpr std::int64_t normalised_region_sum = (region_area << formats::normalised_region_sum::fraction) - 1;

// v_i is at most 1 but for the roundings of its conspicuity C, which is stored truncated from the sum of X~,
// each truncated too: at every pixel X~_i < C + 2^-fraction of C + 2^-20. Over a region of `area` pixels
// with a sum of C of at least its last bit that is
//   v_i < 1 + area (1 + 2^(fraction - 20)).
// One entry is not above that by its own rounding: half a bit, which the bound, a number of whole bits that
// is never reached, has room for.
constexpr std::int64_t descriptor_entry =
    (std::int64_t{1} << formats::descriptor_entry::fraction) * (1 + region_area) +
    (region_area << formats::descriptor_entry::fraction >>
     (formats::normalised::fraction - formats::intensity_conspicuity::fraction));

static_assert(holds_tightly<formats::stop_ratio>(signature_record::max_stop_ratio), "range");
static_assert(formats::stop_ratio::fraction == signature_record::stop_ratio_fraction, "one format");
static_assert(holds_tightly<formats::intensity_region_sum>(region_area * intensity_feature), "range");
static_assert(holds_tightly<formats::colour_region_sum>(region_area * colour_feature), "range");
static_assert(holds_tightly<formats::orientation_region_sum>(region_area * orientation_feature), "range");
static_assert(holds_tightly<formats::intensity_conspicuity_region_sum>(region_area * intensity_conspicuity),
              "range");
static_assert(holds_tightly<formats::colour_conspicuity_region_sum>(region_area * colour_conspicuity),
              "range");
static_assert(holds_tightly<formats::orientation_conspicuity_region_sum>(region_area *
                                                                         orientation_conspicuity),
              "range");
static_assert(holds_tightly<formats::normalised_region_sum>(normalised_region_sum), "range");
static_assert(holds_tightly<formats::descriptor_entry>(descriptor_entry), "range");

// The integers between the points: the product before the gain's shift, the divisor, and the rest of the
// division, which is below twice the divisor.
static_assert(formats::intensity_region_sum::word + formats::gain::word +
                      formats::normalised_region_sum::fraction - formats::gain::fraction <=
                  64,
              "normalised_region_sum");
constexpr std::int64_t largest_divisor =
    max_of(entry_divisor<formats::intensity_conspicuity_region_sum>(
               static_cast<std::uint32_t>(region_area * intensity_conspicuity)),
           entry_divisor<formats::colour_conspicuity_region_sum>(
               static_cast<std::uint32_t>(region_area* colour_conspicuity)));
static_assert(2 * largest_divisor < two_to(32), "descriptor_entry");

}  // namespace ranges
}  // namespace hls
}  // namespace sailmap
