// Reading one object of a configuration file, with the object's and the key's name in whatever is wrong.
#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace sailmap::app {

class JsonFields {
 public:
  // `where` names the object in messages, and so does its own "name" once it is read. Throws Error when it is
  // no object, or has a key that is not among `known`.
  JsonFields(const nlohmann::json& object, std::string where, std::initializer_list<std::string_view> known);

  [[nodiscard]] bool has(const char* key) const { return object_.contains(key); }
  // Throws Error when the value is of another kind or out of range.
  [[nodiscard]] std::string text(const char* key, const std::string& otherwise = "") const;
  [[nodiscard]] double number(const char* key, double otherwise) const;
  [[nodiscard]] int integer(const char* key, int otherwise, int least, int most) const;
  // What goes wrong with a key, or without one with the whole object.
  [[noreturn]] void fail(const std::string& fault) const;

 private:
  const nlohmann::json& object_;
  std::string where_;
};

}  // namespace sailmap::app
