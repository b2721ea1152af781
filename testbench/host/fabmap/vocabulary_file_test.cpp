// Vocabulary files: what is written comes back, and what is wrong is told.
#include <gmock/gmock.h>

#include <opencv2/core.hpp>

#include "sailmap/error.hpp"
#include "sailmap/fabmap.hpp"
#include "temporary_folder.hpp"

namespace sailmap::fabmap {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(VocabularyFile, IsReadAsWritten) {
  const testing::TemporaryFolder folder;
  const std::vector<Words> images = {{0, 1, 2}, {0, 1}, {2}, {}};
  Vocabulary written{cv::Mat::ones(3, 128, CV_32F), learn_tree(images, 3), images};
  written.features = 321;
  write_vocabulary(folder.path() / "v.json", written);
  const Vocabulary read = read_vocabulary(folder.path() / "v.json");
  EXPECT_EQ(read.training, written.training);
  EXPECT_EQ(read.features, 321);
  EXPECT_EQ(cv::countNonZero(read.centres != written.centres), 0);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read.tree[i].parent, written.tree[i].parent);
    EXPECT_EQ(read.tree[i].given_parent, written.tree[i].given_parent);
  }
}

TEST(VocabularyFile, DamageIsNamed) {
  const testing::TemporaryFolder folder;
  const auto expect_fault = [&](const std::string& text, const std::string& fault) {
    const auto path = folder.file("v.json", text);
    EXPECT_THAT([&] { read_vocabulary(path); },
                ThrowsMessage<Error>(AllOf(HasSubstr("v.json: "), HasSubstr(fault))));
  };
  expect_fault("", "damaged");
  expect_fault("{}", "damaged");
  expect_fault(R"({"format": "else"})", "not a sailmap vocabulary");
  expect_fault(R"({"format": "sailmap fabmap vocabulary", "version": 9})", "version 9");
  expect_fault(
      R"({"format": "sailmap fabmap vocabulary", "version": 1, "features": 500, "centres": [], "tree": [],
          "training": []})",
      "0 words");
  const std::string beginning = R"({"format": "sailmap fabmap vocabulary", "version": )";
  expect_fault(beginning + std::string(200000, '[') + std::string(200000, ']') + "}", "not array");
  expect_fault(beginning + "1.5}", "a whole number expected, not 1.5");
  expect_fault(beginning + R"(4294967297})", "a whole number expected, not 4294967297");
  EXPECT_THAT([&] { read_vocabulary(folder.path() / "none.json"); },
              ThrowsMessage<Error>(HasSubstr("none.json")));
}

}  // namespace
}  // namespace sailmap::fabmap
