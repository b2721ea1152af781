// What the simulated kernel writes is what the top between memory and memory writes (testbench/top has the
// top's side): words of the quantised reference, and the report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "csim/expected.hpp"
#include "frontends/xrt/simulated_device.hpp"
#include "pictures.hpp"

namespace sailmap::testing {
namespace {

using namespace fpga;

class Memory : public Slot {
 public:
  explicit Memory(const BufferSizes& sizes) {
    for (std::size_t i = 0; i < buffer_count; ++i) buffers[i].assign(sizes[i], std::byte{0xa5});
  }
  [[nodiscard]] std::span<std::byte> memory(Buffer buffer) override { return buffers[index_of(buffer)]; }
  void start(const Call& /*call*/) override {}
  [[nodiscard]] Outcome wait(std::chrono::milliseconds /*timeout*/) override { return Outcome::done; }

  template <class Word>
  [[nodiscard]] std::vector<Word> all(Buffer buffer) {
    const auto words = Slot::words<Word>(buffer, buffers[index_of(buffer)].size());
    return {words.begin(), words.end()};
  }
  std::array<std::vector<std::byte>, buffer_count> buffers;
};

TEST(SimulatedKernel, WritesTheWordsOfTheReference) {
  const Picture image = picture(5, 88, 70);
  csim::Frame frame{image.width, image.height, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto [r, g, b] = image.view().at(x, y);
      for (const int value : {r, g, b}) frame.rgb.push_back(static_cast<std::uint8_t>(value));
    }
  }
  Memory slot(buffer_sizes(88, 70));
  for (std::size_t i = 0; i < frame.rgb.size(); ++i) {
    slot.buffers[0][i / 3 * 4 + i % 3] = std::byte{frame.rgb[i]};
  }
  run_kernel(slot, {88, 70, 9}, {640, 480, 8});
  const csim::FrontEndWords want = expected(frame);
  EXPECT_EQ(slot.all<std::uint32_t>(Buffer::intensity_maps), want.intensity_maps);
  EXPECT_EQ(slot.all<std::uint64_t>(Buffer::colour_maps), want.colour_maps);
  EXPECT_EQ(slot.all<std::uint64_t>(Buffer::orientation_maps), want.orientation_maps);
  EXPECT_EQ(slot.all<std::uint64_t>(Buffer::conspicuity_maps), want.conspicuity_maps);
  EXPECT_EQ(slot.all<std::uint16_t>(Buffer::saliency), want.saliency);
  EXPECT_EQ(slot.all<std::uint32_t>(Buffer::statistics), want.statistics);
  EXPECT_THAT(slot.all<std::uint32_t>(Buffer::report),
              ::testing::ElementsAre(0x534d0001U, 640U, 480U, 8U, 64U, 88U, 70U, 9U, want.saliency.size(), 1U,
                                     0U, 0U, 0U, 0U, 0U, 0U));
}

TEST(SimulatedKernel, RefusesWhatTheKernelDoesNotTake) {
  for (const Call call :
       {Call{0, 0, 3}, Call{63, 64, 3}, Call{644, 64, 3}, Call{66, 64, 3}, Call{64, 481, 3}}) {
    Memory slot(buffer_sizes(644, 482));
    const auto before = slot.buffers;
    run_kernel(slot, call, {640, 480, 4});
    EXPECT_EQ(slot.all<std::uint32_t>(Buffer::report)[SAILMAP_REPORT_STATUS], 2U);
    EXPECT_EQ(slot.all<std::uint32_t>(Buffer::report)[SAILMAP_REPORT_MAP_WORDS], 0U);
    slot.buffers[index_of(Buffer::report)] = before[index_of(Buffer::report)];
    EXPECT_TRUE(slot.buffers == before);
  }
}

TEST(BufferSizes, OfFrames) {
  EXPECT_THAT(buffer_sizes(640, 480),
              ::testing::ElementsAre(1228800, 76800, 153600, 153600, 153600, 38400, 104, 64));
  EXPECT_THAT(buffer_sizes(65, 66), ::testing::ElementsAre(17160, 1156, 2312, 2312, 2312, 578, 104, 64));
  EXPECT_THAT(buffer_sizes(0, 0), ::testing::ElementsAre(0, 0, 0, 0, 0, 0, 0, 64));
}

TEST(SimulationText, IsRead) {
  const Simulation plain = simulation_from_text("1280x720x8");
  EXPECT_EQ(plain.limits.max_width, 1280U);
  EXPECT_EQ(plain.limits.max_height, 720U);
  EXPECT_EQ(plain.limits.beat, 8U);
  EXPECT_EQ(plain.fault, Fault::none);
  const Simulation hanging = simulation_from_text("96x72x4 hang 3");
  EXPECT_EQ(hanging.fault, Fault::hang);
  EXPECT_EQ(hanging.good_frames, 3);
  EXPECT_EQ(simulation_from_text("96x72x4 gather 2").gather, 2);
  for (const char* text : {"", "640", "640x480x4 gather", "640x480", "640x480x4 burn", "axbxc"}) {
    EXPECT_THROW(simulation_from_text(text), Error) << text;
  }
}

}  // namespace
}  // namespace sailmap::testing
