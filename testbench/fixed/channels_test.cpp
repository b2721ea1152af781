// Section 2 in vectors against the kernels' scalar steps, for every colour there is.
#include "frontends/fixed/channels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "fixed/targets.hpp"
#include "sailmap/hls/arithmetic.hpp"

namespace sailmap::fixed {
namespace {

int unbiased(Sample sample) { return sample + bias; }

struct Row {
  std::array<std::vector<Sample>, channel_count> samples;

  explicit Row(int width) { samples.fill(std::vector<Sample>(static_cast<std::size_t>(width))); }
  [[nodiscard]] std::array<Sample*, channel_count> pointers() {
    std::array<Sample*, channel_count> out{};
    for (std::size_t c = 0; c < out.size(); ++c) out.at(c) = samples.at(c).data();
    return out;
  }
};

// The number of pixels with this r that are not as they should be.
int wrong_pixels(int r) {
  constexpr int side = 256;
  std::vector<std::uint8_t> pixels;
  for (int gb = 0; gb < side * side; ++gb) {
    for (const int v : {r, gb / side, gb % side}) pixels.push_back(static_cast<std::uint8_t>(v));
  }
  Row row(side * side);
  channels({side * side, 1, pixels.data(), 0, ChannelOrder::rgb}, 0, row.pointers());
  int wrong = 0;
  for (int gb = 0; gb < side * side; ++gb) {
    const int g = gb / side;
    const int b = gb % side;
    const std::uint32_t k = hls::colour_reciprocal(r + g + b);
    const auto i = static_cast<std::size_t>(gb);
    const auto is = [&](Channel channel, int doubled) {
      return unbiased(row.samples[channel][i]) == hls::tuned_colour(k, doubled);
    };
    const bool right = row.samples[intensity][i] + grey_bias == r + g + b && is(red, 2 * r - g - b) &&
                       is(green, 2 * g - r - b) && is(blue, 2 * b - r - g) &&
                       is(yellow, 2 * std::min(r, g) - 2 * b);
    wrong += right ? 0 : 1;
  }
  return wrong;
}

TEST(FixedChannels, EveryColourWithTheProcessorsInstructions) {
  for (int r = 0; r < 256; ++r) ASSERT_EQ(wrong_pixels(r), 0) << "r = " << r;
}

TEST(FixedChannels, EverySumWithEveryInstructionSet) {
  for (const std::int64_t target : testing::targets()) {
    const testing::UseTarget use(target);
    // g and b from 0 to 255 reach the sums from r to r + 510.
    for (const int r : {0, 1, 76, 77, 128, 255}) {
      ASSERT_EQ(wrong_pixels(r), 0) << testing::name_of(target) << ", r = " << r;
    }
  }
}

}  // namespace
}  // namespace sailmap::fixed
