// Where the real image sequences are; tests that need them skip visibly without.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace sailmap::testing {

inline std::filesystem::path data_folder() {
  const char* folder = std::getenv("SAILMAP_DATA");
  return folder != nullptr ? std::filesystem::path(folder) : std::filesystem::path(SAILMAP_DEFAULT_DATA);
}

}  // namespace sailmap::testing

// In a test body: skips, saying why, when `name` (a folder or file of the data) is not there.
#define SAILMAP_NEEDS_DATA(name)                                                                          \
  if (!std::filesystem::exists(sailmap::testing::data_folder() / (name))) {                               \
    GTEST_SKIP() << "no " << (name) << " in " << sailmap::testing::data_folder() << "; set SAILMAP_DATA"; \
  }
