// Tools that tests need beside the library. Without one a test skips and says so; scripts/test, which
// installs them all, sets SAILMAP_TOOLS=required, and then the test fails instead: nothing passes there by
// not being run.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string_view>

namespace sailmap::testing {

inline bool tools_are_required() {
  const char* wish = std::getenv("SAILMAP_TOOLS");
  return wish != nullptr && std::string_view(wish) == "required";
}

}  // namespace sailmap::testing

// In a test body or SetUp: `what` is missing when `found` is false.
#define SAILMAP_NEEDS_TOOL(found, what)                                                 \
  if (!(found)) {                                                                       \
    if (sailmap::testing::tools_are_required()) {                                       \
      GTEST_FAIL() << "no " << (what) << ", which scripts/setup should have installed"; \
    }                                                                                   \
    GTEST_SKIP() << "no " << (what);                                                    \
  }
