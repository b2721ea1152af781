// The C simulation behind the interface the host sees: the same maps as `quantised`, with their formats and
// statistics.
#include "sailmap/frontend.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "csim/frames.hpp"
#include "sailmap/error.hpp"

namespace sailmap::testing {
namespace {

void expect_equal(const Map& got, const Map& want) {
  EXPECT_EQ(got.format, want.format);
  EXPECT_EQ(got.lsb, want.lsb);
  EXPECT_TRUE(got.samples == want.samples) << want.format;
}

TEST(CsimFrontend, MapsEqualThoseOfQuantised) {
  std::mt19937 random(11);
  const auto csim = make_frontend("csim");
  const auto quantised = make_frontend("quantised");
  Maps got;
  for (const auto& [width, height] : {std::pair{101, 67}, {96, 80}}) {
    const csim::Frame frame = patches_frame(width, height, random);
    // Blue first, and rows that do not follow each other directly.
    const std::ptrdiff_t stride = 3L * width + 5;
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(stride * height), 77);
    for (int y = 0; y < height; ++y) {
      std::copy_n(frame.rgb.begin() + 3L * width * y, 3L * width, pixels.begin() + stride * y);
    }
    const ImageView image{width, height, pixels.data(), stride, ChannelOrder::bgr};
    Maps want;
    csim->compute(image, got);
    quantised->compute(image, want);
    EXPECT_EQ(got.image_width, width);
    EXPECT_EQ(got.image_height, height);
    EXPECT_EQ(got.feature_statistics, want.feature_statistics);
    for (std::size_t i = 0; i < feature_count; ++i) expect_equal(got.features[i], want.features[i]);
    for (std::size_t i = 0; i < conspicuity_count; ++i)
      expect_equal(got.conspicuities[i], want.conspicuities[i]);
    expect_equal(got.saliency, want.saliency);
  }
}

TEST(CsimFrontend, RefusesImagesOfAWrongSize) {
  const std::vector<std::uint8_t> pixels(3 * 63 * 64);
  Maps maps;
  EXPECT_THROW(make_frontend("csim")->compute({63, 64, pixels.data(), 3L * 63, ChannelOrder::rgb}, maps),
               Error);
}

}  // namespace
}  // namespace sailmap::testing
