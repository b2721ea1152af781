#include "sailmap/number_format.hpp"

#include <algorithm>

#include "sailmap/hls/formats.hpp"

namespace sailmap {
namespace {

constexpr std::string_view rounding_name(hls::Rounding rounding) {
  switch (rounding) {
    case hls::Rounding::rnd:
      return "SC_RND";
    case hls::Rounding::rnd_zero:
      return "SC_RND_ZERO";
    case hls::Rounding::rnd_min_inf:
      return "SC_RND_MIN_INF";
    case hls::Rounding::rnd_inf:
      return "SC_RND_INF";
    case hls::Rounding::rnd_conv:
      return "SC_RND_CONV";
    case hls::Rounding::trn:
      return "SC_TRN";
    case hls::Rounding::trn_zero:
      return "SC_TRN_ZERO";
  }
  return "";
}

constexpr std::string_view overflow_name(hls::Overflow overflow) {
  switch (overflow) {
    case hls::Overflow::sat:
      return "SC_SAT";
    case hls::Overflow::sat_zero:
      return "SC_SAT_ZERO";
    case hls::Overflow::sat_sym:
      return "SC_SAT_SYM";
    case hls::Overflow::wrap:
      return "SC_WRAP";
    case hls::Overflow::wrap_sm:
      return "SC_WRAP_SM";
  }
  return "";
}

template <class F>
constexpr NumberFormat entry(std::string_view unit_name, std::string_view what) {
  return {
      F::name(), F::word,   F::fraction, F::is_signed, rounding_name(F::rounding), overflow_name(F::overflow),
      unit_name, F::unit(), what};
}

#define SAILMAP_NUMBER_FORMAT(name_, word_, fraction_, sign_, rounding_, overflow_, unit_, what_) \
  entry<hls::formats::name_>(#unit_, what_),
constexpr NumberFormat formats[] = {SAILMAP_FORMAT_TABLE(SAILMAP_NUMBER_FORMAT)};
#undef SAILMAP_NUMBER_FORMAT

}  // namespace

std::span<const NumberFormat> number_formats() { return formats; }

const NumberFormat* find_number_format(std::string_view name) {
  const auto* const found = std::ranges::find(formats, name, &NumberFormat::name);
  return found == std::end(formats) ? nullptr : found;
}

}  // namespace sailmap
