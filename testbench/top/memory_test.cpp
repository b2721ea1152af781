// The top between memory and memory: the words of the quantised reference at their places, nothing beyond
// them, and a report of every start.
#include "memory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "csim/expected.hpp"
#include "csim/frames.hpp"
#include "memory_words.hpp"

namespace sailmap::testing {
namespace {

// The kernel and memory for its largest frame, one word more a port.
struct Memory {
  csim::FrontEndWords words;
  Report report{};

  Memory() {
    const std::size_t count = top::map_words + 1;
    words.intensity_maps.assign(count, untouched);
    words.colour_maps.assign(count, untouched);
    words.orientation_maps.assign(count, untouched);
    words.conspicuity_maps.assign(count, untouched);
    words.saliency.assign(count, static_cast<std::uint16_t>(untouched));
    words.statistics.assign(SAILMAP_STATISTICS_WORDS + 1, untouched);
    report.fill(untouched);
  }
  void run(const std::vector<sailmap_memory_beat>& pixels, std::uint32_t width, std::uint32_t height,
           std::uint32_t frame) {
    sailmap_memory(pixels.data(), words.intensity_maps.data(), words.colour_maps.data(),
                   words.orientation_maps.data(), words.conspicuity_maps.data(), words.saliency.data(),
                   words.statistics.data(), report.data(), width, height, frame);
  }
};

TEST(MemoryTop, FrameAfterFrameEqualsTheReference) {
  std::mt19937 random(11);
  std::uint32_t tag = 7;
  for (const csim::Frame& frame :
       {patches_frame(160, 120, random), noise_frame(96, 65, random), patches_frame(160, 128, random)}) {
    Memory memory;
    memory.run(beats_of(frame), static_cast<std::uint32_t>(frame.width),
               static_cast<std::uint32_t>(frame.height), ++tag);
    const csim::FrontEndWords want = expected(frame);
    expect_words(memory.words.intensity_maps, want.intensity_maps);
    expect_words(memory.words.colour_maps, want.colour_maps);
    expect_words(memory.words.orientation_maps, want.orientation_maps);
    expect_words(memory.words.conspicuity_maps, want.conspicuity_maps);
    expect_words(memory.words.saliency, want.saliency);
    expect_words(memory.words.statistics, want.statistics);
    EXPECT_THAT(memory.report, ::testing::ElementsAre(0x534d0001U, Config::max_width, Config::max_height,
                                                      Config::beat, 64U, frame.width, frame.height, tag,
                                                      want.saliency.size(), 1U, 0U, 0U, 0U, 0U, 0U, 0U));
  }
}

TEST(MemoryTop, ASizeItDoesNotTakeIsRefusedAndNothingButTheReportWritten) {
  const std::vector<sailmap_memory_beat> pixels(1);
  const Memory before;
  for (const auto& [width, height] : refused_sizes()) {
    Memory memory;
    memory.run(pixels, width, height, 3);
    EXPECT_TRUE(memory.words == before.words) << width << "x" << height;
    EXPECT_EQ(memory.report[SAILMAP_REPORT_STATUS], 2U);
    EXPECT_EQ(memory.report[SAILMAP_REPORT_OUTPUT_WORDS], 0U);
    EXPECT_EQ(memory.report[SAILMAP_REPORT_WIDTH], width);
    EXPECT_EQ(memory.report[SAILMAP_REPORT_HEIGHT], height);
    EXPECT_EQ(memory.report[SAILMAP_REPORT_VERSION], 0x534d0001U);
  }
}

}  // namespace
}  // namespace sailmap::testing
