#include <gmock/gmock.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "sailmap/image_source.hpp"

namespace sailmap {
namespace {

std::vector<std::string> sorted(std::vector<std::string> names) {
  std::ranges::sort(names, natural_less);
  return names;
}

TEST(NaturalOrder, ComparesDigitsAsNumbers) {
  EXPECT_THAT(sorted({"img10.png", "img2.png", "img1.png", "img100.png"}),
              ::testing::ElementsAre("img1.png", "img2.png", "img10.png", "img100.png"));
}

TEST(NaturalOrder, ComparesSeveralNumbersInTurn) {
  EXPECT_THAT(sorted({"run10/2.png", "run2/10.png", "run2/9.png"}),
              ::testing::ElementsAre("run2/9.png", "run2/10.png", "run10/2.png"));
}

TEST(NaturalOrder, TakesNumbersOfAnyLength) {
  const std::string nanoseconds = "1403636579763555584000000000000000000";
  EXPECT_THAT(sorted({nanoseconds + "1", nanoseconds + "0", "9"}),
              ::testing::ElementsAre("9", nanoseconds + "0", nanoseconds + "1"));
}

TEST(NaturalOrder, TellsLeadingZerosApartOnlyAtTheEnd) {
  EXPECT_THAT(sorted({"1", "01", "001b", "1a", "0"}), ::testing::ElementsAre("0", "01", "1", "1a", "001b"));
  EXPECT_FALSE(natural_less("7", "7"));
}

TEST(NaturalOrder, PutsThePrefixFirst) {
  EXPECT_TRUE(natural_less("frame", "frame1"));
  EXPECT_FALSE(natural_less("frame1", "frame"));
  EXPECT_TRUE(natural_less("", "0"));
}

// std::sort is undefined unless the order is strict, total and transitive.
TEST(NaturalOrder, IsATotalOrder) {
  std::mt19937 random(7);
  std::uniform_int_distribution<std::size_t> length(0, 5);
  std::uniform_int_distribution<std::size_t> letter(0, 4);
  std::vector<std::string> names(120);
  for (std::string& name : names) {
    name.resize(length(random));
    for (char& c : name) c = "012a\xE9"[letter(random)];
  }
  for (const auto& a : names) {
    for (const auto& b : names) {
      EXPECT_EQ(static_cast<int>(natural_less(a, b)) + static_cast<int>(natural_less(b, a)), a == b ? 0 : 1);
      for (const auto& c : names) {
        const bool chained = natural_less(a, b) && natural_less(b, c);
        EXPECT_TRUE(!chained || natural_less(a, c)) << a << ' ' << b << ' ' << c;
      }
    }
  }
}

}  // namespace
}  // namespace sailmap
