// The arithmetic of the memory table, against what the data sheets of the devices say (UG473, UG474).
#include "memories.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace sailmap::memories {
namespace {

TEST(Memories, BlockRamsHaveTheShapesOfTheDataSheet) {
  EXPECT_EQ(half_block_rams(512, 36), 1);
  EXPECT_EQ(half_block_rams(513, 36), 2);
  EXPECT_EQ(half_block_rams(512, 72), 2);
  EXPECT_EQ(half_block_rams(1024, 18), 1);
  EXPECT_EQ(half_block_rams(1025, 16), 2);
  EXPECT_EQ(half_block_rams(2048, 9), 1);
  EXPECT_EQ(half_block_rams(16384, 1), 1);
}

TEST(Memories, DistributedMemoryIsFourLutsForSixtyFourWordsOfThreeBits) {
  EXPECT_EQ(memory_luts(64, 3), 4);
  EXPECT_EQ(memory_luts(65, 3), 8);
  EXPECT_EQ(memory_luts(64, 4), 8);
  EXPECT_EQ(memory_luts(32, 6), 4);
}

long bits(const std::vector<Memory>& all, const std::string& prefix) {
  return std::accumulate(all.begin(), all.end(), 0L, [&](long sum, const Memory& memory) {
    const bool counts = memory.what.rfind(prefix, 0) == 0;
    return sum + (counts ? static_cast<long>(memory.copies) * memory.words * memory.bits : 0);
  });
}

// By hand: ten feature maps of 16 bits, each with a flag.
TEST(Memories, StoresOfVga) {
  constexpr long pixels = 160 * 120;
  EXPECT_EQ(bits(of_front_end<hls::Vga<8>>(), "store"), pixels * 10 * 17);
  EXPECT_EQ(bits(of_front_end<hls::Vga<8, true>>(), "store"), 2 * pixels * 10 * 17);
}

// By hand: of each conspicuity map the local maxima, one of four pixels at most, and a word of 16 bits more.
TEST(Memories, LocalMaximaOfVga) {
  constexpr long most = 80 * 60;
  EXPECT_EQ(bits(of_front_end<hls::Vga<8>>(), "local maxima of conspicuity"), 3 * (most + 1) * 16);
}

// By hand: thirteen maps and saliency of 16 bits a pixel, and 32 bits a row.
TEST(Memories, SignatureOfVga) {
  constexpr long pixels = 160 * 120;
  EXPECT_EQ(bits(of_signature<hls::Vga<8>>(), "signature"),
            pixels * 14 * 16 + 120 * 32 + 2 * 10 * 32 + 20 * (32 + 16));
}

// By hand, five channels of 16 bits: 30 rows of 160 and 10 of 80, and one row more of each.
TEST(Memories, DelaysOfVga) {
  EXPECT_EQ(bits(of_front_end<hls::Vga<4>>(), "level 2: delay of the c") +
                bits(of_front_end<hls::Vga<4>>(), "level 3: delay of the c"),
            (31 * 160 + 11 * 80) * 4 * 16);
}

}  // namespace
}  // namespace sailmap::memories
