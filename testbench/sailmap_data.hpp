// Where the real image sequences are; tests that need them skip visibly without.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace sailmap::testing {

// SAILMAP_DATA, or what CTest says is the default, or the default as seen from the root of a checkout.
inline std::filesystem::path data_folder() {
  for (const char* variable : {"SAILMAP_DATA", "SAILMAP_DEFAULT_DATA"}) {
    if (const char* folder = std::getenv(variable); folder != nullptr) return folder;
  }
  return "../shared/data";
}

}  // namespace sailmap::testing

// In a test body: skips, saying why, when `name` (a folder or file of the data) is not there.
#define SAILMAP_NEEDS_DATA(name)                                                                          \
  if (!std::filesystem::exists(sailmap::testing::data_folder() / (name))) {                               \
    GTEST_SKIP() << "no " << (name) << " in " << sailmap::testing::data_folder() << "; set SAILMAP_DATA"; \
  }
