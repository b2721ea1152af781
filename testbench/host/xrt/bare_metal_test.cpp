// The C functions for systems without XRT against hardware that knows nothing but the register map of
// memory_registers.h: the simulated kernel behind a block of registers.
#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <thread>
#include <vector>

#include "frontends/packed_maps.hpp"
#include "frontends/xrt/simulated_device.hpp"
#include "pictures.hpp"
#include "sailmap_memory.h"

namespace sailmap::testing {
namespace {

using namespace fpga;

// The registers as the hardware sees them; addresses are those of this process.
class Hardware : public Slot {
 public:
  volatile std::uint32_t registers[SAILMAP_REGISTERS_END / 4] = {};

  // Does what was started; false when nothing was.
  bool work() {
    if ((registers[0] & 1U) == 0) return false;
    const Call call{registers[0x70 / 4], registers[0x78 / 4], registers[0x80 / 4]};
    sizes_ = buffer_sizes(call.width, call.height);
    run_kernel(*this, call, {640, 480, 4});
    registers[0] = 2U | 4U;
    return true;
  }

  [[nodiscard]] std::span<std::byte> memory(Buffer buffer) override {
    const std::size_t at = (0x10 + 12 * index_of(buffer)) / 4;
    const std::uint64_t address = registers[at] | static_cast<std::uint64_t>(registers[at + 1]) << 32;
    return {reinterpret_cast<std::byte*>(address), sizes_[index_of(buffer)]};
  }
  void start(const Call& /*call*/) override {}
  [[nodiscard]] Outcome wait(std::chrono::milliseconds /*timeout*/) override { return Outcome::done; }

 private:
  BufferSizes sizes_{};
};

template <class Word>
std::uint64_t address_of(std::vector<Word>& words) {
  return reinterpret_cast<std::uint64_t>(words.data());
}

TEST(BareMetal, AFrameAndItsReport) {
  const Picture image = picture(8, 96, 72);
  constexpr std::size_t words = 24 * 18;
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto [r, g, b] = image.view().at(x, y);
      for (const int value : {r, g, b, 0}) pixels.push_back(static_cast<std::uint8_t>(value));
    }
  }
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
  Hardware hardware;
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

}  // namespace
}  // namespace sailmap::testing
