// The C functions for systems without XRT against hardware that knows nothing but the register map of
// memory_registers.h: the simulated kernels behind a block of registers.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <thread>
#include <vector>

#include "csim/expected_signature.hpp"
#include "frontends/packed_maps.hpp"
#include "frontends/xrt/simulated_device.hpp"
#include "pictures.hpp"
#include "sailmap_memory.h"
#include "sailmap_signature_memory.h"

namespace sailmap::testing {
namespace {

using namespace fpga;

// The registers as the hardware of a kernel sees them: addresses, which are those of this process, from 0x10
// on, and the scalars behind them.
class Hardware : public Slot {
 public:
  explicit Hardware(const KernelInterface& kernel) : kernel_(kernel) {}
  volatile std::uint32_t registers[0x90 / 4] = {};

  // Does what was started; false when nothing was.
  bool work() {
    if ((registers[0] & 1U) == 0) return false;
    const std::size_t scalars = (0x10 + 12 * kernel_.buffers.size()) / 4;
    const auto scalar = [&](std::size_t i) -> std::uint32_t {
      return i < kernel_.scalars ? registers[scalars + 2 * i] : 0;
    };
    const Call call{scalar(0), scalar(1), scalar(2), scalar(3), scalar(4), scalar(5)};
    sizes_ = buffer_sizes(kernel_, call.width, call.height);
    run_kernel(kernel_, *this, call, {640, 480, 4});
    registers[0] = 2U | 4U;
    return true;
  }

  [[nodiscard]] std::span<std::byte> memory(Buffer buffer) override {
    const auto place = std::ranges::find(kernel_.buffers, buffer) - kernel_.buffers.begin();
    const std::size_t at = (0x10 + 12 * static_cast<std::size_t>(place)) / 4;
    const std::uint64_t address = registers[at] | static_cast<std::uint64_t>(registers[at + 1]) << 32;
    return {reinterpret_cast<std::byte*>(address), sizes_[index_of(buffer)]};
  }
  void start(const Call& /*call*/) override {}
  [[nodiscard]] Outcome wait(std::chrono::milliseconds /*timeout*/) override { return Outcome::done; }

 private:
  KernelInterface kernel_;
  BufferSizes sizes_{};
};

template <class Word>
std::uint64_t address_of(std::vector<Word>& words) {
  return reinterpret_cast<std::uint64_t>(words.data());
}

std::vector<std::uint8_t> pixels_of(const Picture& image) {
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto [r, g, b] = image.view().at(x, y);
      for (const int value : {r, g, b, 0}) pixels.push_back(static_cast<std::uint8_t>(value));
    }
  }
  return pixels;
}

TEST(BareMetal, AFrameAndItsReport) {
  const Picture image = picture(8, 96, 72);
  constexpr std::size_t words = 24 * 18;
  std::vector<std::uint8_t> pixels = pixels_of(image);
  std::vector<std::uint32_t> intensity_maps(words);
  std::vector<std::uint64_t> colour_maps(words);
  std::vector<std::uint64_t> orientation_maps(words);
  std::vector<std::uint64_t> conspicuity_maps(words);
  std::vector<std::uint16_t> saliency(words);
  std::vector<std::uint32_t> statistics(SAILMAP_STATISTICS_WORDS);
  std::vector<std::uint32_t> report(SAILMAP_REPORT_WORDS);
  const sailmap_buffers buffers = {address_of(pixels),           address_of(intensity_maps),
                                   address_of(colour_maps),      address_of(orientation_maps),
                                   address_of(conspicuity_maps), address_of(saliency),
                                   address_of(statistics),       address_of(report)};
  Hardware hardware(maps_kernel);
  sailmap_start(hardware.registers, &buffers, 0, 0, 0);
  EXPECT_EQ(sailmap_wait(hardware.registers, 3), -1);
  ASSERT_TRUE(hardware.work());
  EXPECT_EQ(sailmap_wait(hardware.registers, 3), 0);
  EXPECT_EQ(report[SAILMAP_REPORT_VERSION], 0x534d0001U);
  EXPECT_EQ(report[SAILMAP_REPORT_MAX_WIDTH], 640U);

  sailmap_start(hardware.registers, &buffers, 96, 72, 41);
  ASSERT_TRUE(hardware.work());
  EXPECT_EQ(sailmap_wait(hardware.registers, 1), 0);
  EXPECT_EQ(report[SAILMAP_REPORT_STATUS], 1U);
  EXPECT_EQ(report[SAILMAP_REPORT_FRAME], 41U);
  Maps maps;
  unpack({intensity_maps, colour_maps, orientation_maps, conspicuity_maps, saliency, statistics}, 96, 72,
         maps);
  expect_same(maps, expected_maps(image));
}

TEST(BareMetal, AFrameAndItsSignature) {
  const Picture image = picture(9, 96, 72);
  std::vector<std::uint8_t> pixels = pixels_of(image);
  std::vector<std::uint32_t> record(SAILMAP_RECORD_WORDS);
  std::vector<std::uint32_t> report(SAILMAP_REPORT_WORDS);
  const sailmap_signature_buffers buffers = {address_of(pixels), address_of(record), address_of(report)};
  const sailmap_signature_parameters parameters = {7, 8192, 12};
  Hardware hardware(signature_kernel);
  sailmap_signature_start(hardware.registers, &buffers, 0, 0, 0, &parameters);
  EXPECT_EQ(sailmap_wait(hardware.registers, 3), -1);
  ASSERT_TRUE(hardware.work());
  EXPECT_EQ(sailmap_wait(hardware.registers, 3), 0);
  EXPECT_EQ(report[SAILMAP_REPORT_VERSION], 0x53470001U);
  EXPECT_EQ(report[SAILMAP_REPORT_STATUS], 2U);

  sailmap_signature_start(hardware.registers, &buffers, 96, 72, 41, &parameters);
  ASSERT_TRUE(hardware.work());
  EXPECT_EQ(sailmap_wait(hardware.registers, 1), 0);
  EXPECT_EQ(report[SAILMAP_REPORT_STATUS], 1U);
  EXPECT_EQ(report[SAILMAP_REPORT_FRAME], 41U);
  EXPECT_EQ(report[SAILMAP_REPORT_OUTPUT_WORDS], 248U);
  EXPECT_EQ(record, expected_record(ref::compute<ref::Quantised>(image.view()), 96, 72, {7, 0.125, 12}));
}

}  // namespace
}  // namespace sailmap::testing
