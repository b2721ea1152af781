// docs/formats.md is what the table says, word for word.
#include "documents.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace sailmap::numbers {
namespace {

TEST(FormatsDocument, IsCommittedAsGenerated) {
  std::ifstream in(SAILMAP_DOCS "/formats.md");
  ASSERT_TRUE(in) << "run scripts/numbers";
  std::stringstream text;
  text << in.rdbuf();
  EXPECT_EQ(text.str(), formats_document()) << "run scripts/numbers";
}

TEST(FormatsDocument, HasAHandWorkedRow) {
  // 2^-14, and 1/765/64.
  EXPECT_THAT(formats_document(),
              ::testing::HasSubstr("| `colour` | 16 | u2.14 | SC_RND | SC_WRAP | one | 6.1e-05 |"));
  EXPECT_THAT(formats_document(),
              ::testing::HasSubstr("| `intensity` | 16 | u10.6 | SC_RND | SC_WRAP | grey | 2.04e-05 |"));
}

}  // namespace
}  // namespace sailmap::numbers
