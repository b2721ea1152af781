// What the simulated kernels write is what the tops between memory and memory write (testbench/top has the
// tops' side): words of the quantised reference, and the report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "csim/expected.hpp"
#include "csim/expected_signature.hpp"
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

csim::Frame frame_of(const Picture& image) {
  csim::Frame frame{image.width, image.height, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto [r, g, b] = image.view().at(x, y);
      for (const int value : {r, g, b}) frame.rgb.push_back(static_cast<std::uint8_t>(value));
    }
  }
  return frame;
}

// The buffers of a kernel, a frame in them.
struct MemoryWith : Memory {
  MemoryWith(const csim::Frame& frame, const KernelInterface& kernel)
      : Memory(buffer_sizes(kernel, static_cast<std::uint32_t>(frame.width),
                            static_cast<std::uint32_t>(frame.height))) {
    for (std::size_t i = 0; i < frame.rgb.size(); ++i) {
      buffers[0][i / 3 * 4 + i % 3] = std::byte{frame.rgb[i]};
    }
  }
};

TEST(SimulatedKernel, WritesTheWordsOfTheReference) {
  const csim::Frame frame = frame_of(picture(5, 88, 70));
  MemoryWith slot(frame, maps_kernel);
  run_kernel(maps_kernel, slot, {88, 70, 9}, {640, 480, 8});
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

TEST(SimulatedKernel, WritesTheRecordOfTheReference) {
  const csim::Frame frame = frame_of(picture(6, 88, 70));
  const ref::Model model = ref::compute<ref::Quantised>(view(frame));
  const std::vector<std::pair<Call, ref::RegionParameters>> calls = {
      {{88, 70, 9, 20, 1U << 14, 10}, {20, 0.25, 10}},
      {{88, 70, 9, 3, 1U << 13, 5}, {3, 0.125, 5}},
      {{88, 70, 9, 0x10001, 0, 0x10001}, {20, 0, 16}}};  // beyond the limits
  for (const auto& [call, parameters] : calls) {
    for (const std::uint32_t beat : {1U, 2U, 4U, 8U}) {
      MemoryWith slot(frame, signature_kernel);
      run_kernel(signature_kernel, slot, call, {640, 480, beat});
      EXPECT_EQ(slot.all<std::uint32_t>(Buffer::record), expected_record(model, 88, 70, parameters));
      EXPECT_THAT(slot.all<std::uint32_t>(Buffer::report),
                  ::testing::ElementsAre(0x53470001U, 640U, 480U, beat, 64U, 88U, 70U, 9U, 248U, 1U, 0U, 0U,
                                         0U, 0U, 0U, 0U));
    }
  }
}

TEST(SimulatedKernel, RefusesWhatTheKernelDoesNotTake) {
  for (const KernelInterface& kernel : known_kernels) {
    for (const Call call :
         {Call{0, 0, 3}, Call{63, 64, 3}, Call{644, 64, 3}, Call{66, 64, 3}, Call{64, 481, 3}}) {
      Memory slot(buffer_sizes(kernel, 644, 482));
      const auto before = slot.buffers;
      run_kernel(kernel, slot, call, {640, 480, 4});
      EXPECT_EQ(slot.all<std::uint32_t>(Buffer::report)[SAILMAP_REPORT_VERSION], kernel.version);
      EXPECT_EQ(slot.all<std::uint32_t>(Buffer::report)[SAILMAP_REPORT_STATUS], 2U);
      EXPECT_EQ(slot.all<std::uint32_t>(Buffer::report)[SAILMAP_REPORT_OUTPUT_WORDS], 0U);
      slot.buffers[index_of(Buffer::report)] = before[index_of(Buffer::report)];
      EXPECT_TRUE(slot.buffers == before);
    }
  }
}

TEST(BufferSizes, OfFrames) {
  EXPECT_THAT(buffer_sizes(maps_kernel, 640, 480),
              ::testing::ElementsAre(1228800, 76800, 153600, 153600, 153600, 38400, 104, 0, 64));
  EXPECT_THAT(buffer_sizes(maps_kernel, 65, 66),
              ::testing::ElementsAre(17160, 1156, 2312, 2312, 2312, 578, 104, 0, 64));
  EXPECT_THAT(buffer_sizes(maps_kernel, 0, 0), ::testing::ElementsAre(0, 0, 0, 0, 0, 0, 0, 0, 64));
  EXPECT_THAT(buffer_sizes(signature_kernel, 640, 480),
              ::testing::ElementsAre(1228800, 0, 0, 0, 0, 0, 0, 992, 64));
  EXPECT_THAT(buffer_sizes(signature_kernel, 0, 0), ::testing::ElementsAre(0, 0, 0, 0, 0, 0, 0, 0, 64));
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
  EXPECT_THAT(plain.kernels, ::testing::ElementsAre(maps_kernel));
  EXPECT_THAT(simulation_from_text("96x72x4 maps").kernels, ::testing::ElementsAre(maps_kernel));
  EXPECT_THAT(simulation_from_text("96x72x4 both").kernels,
              ::testing::ElementsAre(maps_kernel, signature_kernel));
  const Simulation signatures = simulation_from_text("96x72x4 signature damaged-record 2");
  EXPECT_THAT(signatures.kernels, ::testing::ElementsAre(signature_kernel));
  EXPECT_EQ(signatures.fault, Fault::damaged_record);
  EXPECT_EQ(signatures.good_frames, 2);
  EXPECT_EQ(simulation_from_text("96x72x4 signature gather 2").gather, 2);
  for (const char* text : {"", "640", "640x480x4 gather", "640x480", "640x480x4 burn", "axbxc",
                           "640x480x4 maps both", "640x480x4 signature burn", "signature"}) {
    EXPECT_THROW(simulation_from_text(text), Error) << text;
  }
}

}  // namespace
}  // namespace sailmap::testing
