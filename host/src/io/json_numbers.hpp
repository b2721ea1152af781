// Numbers from JSON documents. nlohmann's own get<int>() and get<float>() cut off digits, wrap around, take
// true for 1, and leave what no int or float can hold undefined.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "sailmap/error.hpp"

namespace sailmap::io {

// Throws Error, without the name of a file, when it is not a whole number that fits.
template <class Json>
int whole_number(const Json& json) {
  constexpr int most = std::numeric_limits<int>::max();
  const bool fits = json.is_number_integer() &&
                    (json.is_number_unsigned() ? json.template get<std::uint64_t>() <= std::uint64_t{most}
                                               : json.template get<std::int64_t>() >= -std::int64_t{most});
  if (fits) return json.template get<int>();
  throw Error("a whole number expected, not " + (json.is_number() ? json.dump() : json.type_name()));
}

// Throws Error, without the name of a file, when it is out of range, and Json::exception when it is no
// number.
template <class Json>
float single(const Json& json) {
  const auto value = json.template get<double>();
  if (!(std::abs(value) <= std::numeric_limits<float>::max())) {
    throw Error("a number is out of range: " + json.dump());
  }
  return static_cast<float>(value);
}

}  // namespace sailmap::io
