#include "json_fields.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "sailmap/error.hpp"

namespace sailmap::app {

using nlohmann::json;

JsonFields::JsonFields(const json& object, std::string where, std::initializer_list<std::string_view> known)
    : object_(object), where_(std::move(where)) {
  if (!object_.is_object()) fail("must be an object");
  if (has("name")) where_ += " '" + text("name") + "'";
  for (const auto& [key, unused] : object_.items()) {
    if (std::ranges::find(known, key) == known.end()) fail("unknown key '" + key + "'");
  }
}

void JsonFields::fail(const std::string& fault) const { throw Error(where_ + ": " + fault); }

std::string JsonFields::text(const char* key, const std::string& otherwise) const {
  if (!has(key)) return otherwise;
  const json& value = object_.at(key);
  if (!value.is_string()) fail(std::string(key) + " must be text");
  return value.get<std::string>();
}

double JsonFields::number(const char* key, double otherwise) const {
  if (!has(key)) return otherwise;
  const json& value = object_.at(key);
  if (!value.is_number()) fail(std::string(key) + " must be a number");
  return value.get<double>();
}

int JsonFields::integer(const char* key, int otherwise, int least, int most) const {
  if (!has(key)) return otherwise;
  const json& value = object_.at(key);
  const bool whole = value.is_number_integer() &&
                     (!value.is_number_unsigned() || value.get<std::uint64_t>() <= std::uint64_t{INT32_MAX});
  if (!whole || value.get<std::int64_t>() < least || value.get<std::int64_t>() > most) {
    fail(std::string(key) + " must be a whole number from " + std::to_string(least) + " to " +
         std::to_string(most));
  }
  return value.get<int>();
}

}  // namespace sailmap::app
