// The number formats of the fixed-point front ends, by name: the table of hls/formats.hpp as data.
#pragma once

#include <span>
#include <string_view>

namespace sailmap {

// value = raw * 2^-fraction * unit, raw an integer of `word` bits.
struct NumberFormat {
  std::string_view name;  // as Map::format has it
  int word = 0;           // bits
  int fraction = 0;       // negative: the last bit is worth more than one unit
  bool is_signed = false;
  std::string_view rounding;   // SystemC's mode (IEEE 1666), such as SC_RND
  std::string_view overflow;   // likewise, such as SC_WRAP
  std::string_view unit_name;  // such as grey21
  double unit = 1;             // in the spec's units
  std::string_view what;       // one line for people
};

// All of them, in the order of the computation.
std::span<const NumberFormat> number_formats();

// nullptr when no fixed-point format has the name (float64).
const NumberFormat* find_number_format(std::string_view name);

}  // namespace sailmap
