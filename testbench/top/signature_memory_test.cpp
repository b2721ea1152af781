// The top from pixels in memory to a signature in memory: the record of the quantised reference, nothing
// beyond it, and a report of every start.
#include "signature_memory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "csim/expected_signature.hpp"
#include "csim/frames.hpp"
#include "memory_words.hpp"

namespace sailmap::testing {
namespace {

// As the registers have them.
struct Asked {
  std::uint32_t max_regions;
  std::uint32_t stop_ratio;
  std::uint32_t box_side;
};

Asked asked_for(const ref::RegionParameters& parameters) {
  return {static_cast<std::uint32_t>(parameters.max_regions),
          static_cast<std::uint32_t>(std::lround(65536 * parameters.stop_ratio)),
          static_cast<std::uint32_t>(parameters.box_side)};
}

// The kernel and memory for its record, one word more.
struct Memory {
  std::vector<std::uint32_t> record = std::vector<std::uint32_t>(SAILMAP_RECORD_WORDS + 1, untouched);
  Report report{};

  Memory() { report.fill(untouched); }
  void run(const std::vector<sailmap_memory_beat>& pixels, std::uint32_t width, std::uint32_t height,
           std::uint32_t frame, const Asked& asked) {
    sailmap_signature_memory(pixels.data(), record.data(), report.data(), width, height, frame,
                             asked.max_regions, asked.stop_ratio, asked.box_side);
  }
  void run(const csim::Frame& frame, std::uint32_t tag, const Asked& asked) {
    run(beats_of(frame), static_cast<std::uint32_t>(frame.width), static_cast<std::uint32_t>(frame.height),
        tag, asked);
  }
};

std::vector<std::uint32_t> expected_of(const csim::Frame& frame, const ref::RegionParameters& parameters) {
  return expected_record(ref::compute<ref::Quantised>(view(frame)), frame.width, frame.height, parameters);
}

TEST(SignatureMemoryTop, FrameAfterFrameEqualsTheReference) {
  std::mt19937 random(12);
  std::uint32_t tag = 7;
  for (const csim::Frame& frame : {patches_frame(160, 120, random), noise_frame(96, 65, random),
                                   constant_frame(64, 64, 9, 9, 9), patches_frame(160, 128, random)}) {
    for (const ref::RegionParameters& parameters :
         {ref::RegionParameters{}, ref::RegionParameters{7, 0.125, 13}, ref::RegionParameters{20, 0, 2}}) {
      Memory memory;
      memory.run(frame, ++tag, asked_for(parameters));
      expect_words(memory.record, expected_of(frame, parameters));
      EXPECT_THAT(memory.report, ::testing::ElementsAre(0x53470001U, Config::max_width, Config::max_height,
                                                        Config::beat, 64U, frame.width, frame.height, tag,
                                                        248U, 1U, 0U, 0U, 0U, 0U, 0U, 0U));
    }
  }
}

// Registers have 32 bits: numbers beyond the kernel's own must not come back as small ones.
TEST(SignatureMemoryTop, ParametersCountAsTheNearestWithinTheirLimits) {
  std::mt19937 random(13);
  const csim::Frame frame = patches_frame(160, 120, random);
  const std::vector<std::pair<Asked, ref::RegionParameters>> cases = {
      {{0, 0, 1}, {1, 0, 2}},
      {{21, 0, 17}, {20, 0, 16}},
      {{0x10005, 0, 0x1000a}, {20, 0, 16}},
      {{0xffffffff, 0, 0xffffffff}, {20, 0, 16}},
      {{20, 65537, 10}, {20, 1, 10}},
      {{20, 0x80000000, 10}, {20, 1, 10}}};
  for (const auto& [asked, within] : cases) {
    Memory memory;
    memory.run(frame, 1, asked);
    expect_words(memory.record, expected_of(frame, within));
  }
}

TEST(SignatureMemoryTop, ASizeItDoesNotTakeIsRefusedAndNothingButTheReportWritten) {
  const std::vector<sailmap_memory_beat> pixels(1);
  for (const auto& [width, height] : refused_sizes()) {
    Memory memory;
    memory.run(pixels, width, height, 3, {20, 0, 10});
    expect_words(memory.record, {});
    EXPECT_THAT(memory.report,
                ::testing::ElementsAre(0x53470001U, Config::max_width, Config::max_height, Config::beat, 64U,
                                       width, height, 3U, 0U, 2U, 0U, 0U, 0U, 0U, 0U, 0U));
  }
}

}  // namespace
}  // namespace sailmap::testing
