// What a message of sailmap::Error must look like.
#pragma once

#include <gmock/gmock.h>

#include <filesystem>
#include <string>

#include "sailmap/error.hpp"

namespace sailmap::testing {

// Matches a callable that throws Error with one line that begins with the file's path and holds `fault`.
inline auto throws_naming(const std::filesystem::path& file, const std::string& fault) {
  using ::testing::AllOf;
  using ::testing::HasSubstr;
  using ::testing::Not;
  using ::testing::StartsWith;
  return ::testing::ThrowsMessage<Error>(
      AllOf(StartsWith(file.string() + ":"), HasSubstr(fault), Not(HasSubstr("\n"))));
}

}  // namespace sailmap::testing
