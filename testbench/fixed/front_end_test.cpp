// `fixed` equals `quantised` bit for bit: all maps, maxima and m, with every instruction set.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <random>

#include "fixed/maps_equal.hpp"
#include "fixed/targets.hpp"
#include "numbers/images.hpp"
#include "sailmap/error.hpp"
#include "sailmap/frontend.hpp"
#include "sailmap_data.hpp"

namespace sailmap::testing {
namespace {

Maps quantised_maps(const ImageView& image) {
  Maps maps;
  make_frontend("quantised")->compute(image, maps);
  return maps;
}

void expect_equal(const ImageView& image) {
  const Maps want = quantised_maps(image);
  for (const std::int64_t target : targets()) {
    const UseTarget use(target);
    Maps got;
    make_frontend("fixed")->compute(image, got);
    EXPECT_EQ(difference(got, want), "")
        << name_of(target) << ", " << image.width << "x" << image.height << " pixels";
  }
}

TEST(FixedFrontEnd, RunsWithMoreThanOneInstructionSet) {
  EXPECT_GE(targets().size(), 2U);  // the processor's own and the fallback
  for (const std::int64_t target : targets()) {
    const UseTarget use(target);
    EXPECT_EQ(hwy::SupportedTargets(), target);
  }
}

// What all the other tests rest on.
TEST(FixedFrontEnd, TheComparisonSeesOneBitAndOneMaximum) {
  const RgbImage image = noise(64, 64, 1);
  const Maps want = quantised_maps(image.view());
  Maps got = want;
  EXPECT_EQ(difference(got, want), "");
  std::get<Plane<std::uint16_t>>(got.saliency.samples)(15, 15) ^= 1U;
  EXPECT_THAT(difference(got, want), ::testing::HasSubstr("at (15, 15)"));
  got = want;
  ++got.conspicuity_statistics[2].maxima;
  EXPECT_THAT(difference(got, want), ::testing::StartsWith("conspicuity_orientation: m = "));
}

TEST(FixedFrontEnd, EqualOnNoiseOfAllContrasts) {
  for (const int most : {1, 3, 30, 128, 255}) expect_equal(noise(131, 97, 7, most).view());
}

TEST(FixedFrontEnd, EqualOnConstantImages) {
  for (const Rgb colour : {black, white, Rgb{255, 0, 0}, Rgb{26, 25, 25}, Rgb{26, 26, 25}, Rgb{1, 0, 0}}) {
    expect_equal(image_of(70, 81, [&](int, int) { return colour; }).view());
  }
}

TEST(FixedFrontEnd, EqualOnSinglePixels) {
  for (const auto& [px, py] : {std::pair{0, 0}, {66, 64}, {66, 0}, {33, 31}, {64, 63}}) {
    for (const bool bright : {true, false}) {
      expect_equal(image_of(67, 65, [&](int x, int y) {
                     return (x == px && y == py) == bright ? white : black;
                   }).view());
    }
  }
}

// Squares and stripes that drive every point to its ends: every fifth, which are some of each kind.
TEST(FixedFrontEnd, EqualOnExtremeImages) {
  const std::vector<RgbImage> images = extreme_images();
  for (std::size_t i = 0; i < images.size(); i += 5) expect_equal(images[i].view());
}

// Columns over all widths and rows over all heights from 64 to 100, so every phase of every vector and level.
TEST(FixedFrontEnd, EqualOnAllSmallSizes) {
  for (int side = 64; side <= 100; ++side) {
    const int other = 64 + side * 7 % 37;
    expect_equal(noise(side, other, static_cast<unsigned>(side)).view());
    expect_equal(noise(other, side, static_cast<unsigned>(side) + 1000, 60).view());
  }
}

TEST(FixedFrontEnd, EqualOnLargerOddSizes) {
  for (const auto& [width, height] : {std::pair{641, 67}, {509, 251}, {64, 1027}, {1923, 65}, {4096, 64}}) {
    expect_equal(noise(width, height, 5).view());
  }
}

TEST(FixedFrontEnd, EqualOnRandomImages) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (int i = 0; i < 10; ++i) {
    const auto side = [&] { return 64 + static_cast<int>(random() % 150); };
    expect_equal(
        noise(side(), side(), static_cast<unsigned>(random()), static_cast<int>(random() % 256)).view());
  }
}

TEST(FixedFrontEnd, TakesBothOrdersAndPaddedRows) {
  const RgbImage tight = noise(90, 70, 3);
  Maps got;
  const auto fixed = make_frontend("fixed");
  for (const ChannelOrder order : {ChannelOrder::rgb, ChannelOrder::bgr}) {
    for (const int padding : {0, 1, 37}) {
      const std::ptrdiff_t stride = 3 * tight.width + padding;
      std::vector<std::uint8_t> pixels(static_cast<std::size_t>(stride * tight.height), 0xa5);
      for (int y = 0; y < tight.height; ++y) {
        std::copy_n(tight.pixels.begin() + y * std::ptrdiff_t{3} * tight.width, 3 * tight.width,
                    pixels.begin() + y * stride);
      }
      const ImageView view{tight.width, tight.height, pixels.data(), stride, order};
      fixed->compute(view, got);
      EXPECT_EQ(difference(got, quantised_maps(view)), "") << stride;
    }
  }
}

// An upside-down image: rows in falling order.
TEST(FixedFrontEnd, TakesRowsBackwards) {
  const RgbImage image = noise(90, 70, 3);
  const ImageView view{image.width, image.height, &image.pixels[std::size_t{3} * 90 * 69],
                       -std::ptrdiff_t{3} * image.width, ChannelOrder::rgb};
  expect_equal(view);
}

TEST(FixedFrontEnd, LeavesNothingOfFramesOfOtherSizes) {
  const auto fixed = make_frontend("fixed");
  Maps maps;
  for (const auto& [width, height] :
       {std::pair{300, 200}, {64, 64}, {131, 97}, {97, 131}, {300, 200}, {299, 201}, {64, 300}}) {
    const RgbImage image = noise(width, height, static_cast<unsigned>(width));
    fixed->compute(image.view(), maps);
    EXPECT_EQ(difference(maps, quantised_maps(image.view())), "") << width << "x" << height;
  }
}

TEST(FixedFrontEnd, RefusesSizesOutOfRange) {
  const auto fixed = make_frontend("fixed");
  Maps maps;
  EXPECT_THROW(fixed->compute(noise(63, 70, 1).view(), maps), Error);
  EXPECT_THROW(fixed->compute(noise(70, 63, 1).view(), maps), Error);
  EXPECT_THROW(fixed->compute(noise(4097, 64, 1).view(), maps), Error);
}

// Every so manieth image of a folder.
void expect_equal_on(const std::string& folder, std::size_t every) {
  std::vector<cv::String> files;
  cv::glob((data_folder() / folder / "images").string(), files);
  ASSERT_FALSE(files.empty());
  for (std::size_t i = 0; i < files.size(); i += every) {
    const cv::Mat image = cv::imread(files[i], cv::IMREAD_COLOR);
    ASSERT_FALSE(image.empty()) << files[i];
    SCOPED_TRACE(files[i]);
    expect_equal({image.cols, image.rows, image.data, static_cast<std::ptrdiff_t>(image.step)});
  }
}

TEST(FixedFrontEnd, EqualOnPhotographsOfTheCorridor) {
  SAILMAP_NEEDS_DATA("rtabmap_corridor");
  expect_equal_on("rtabmap_corridor", 42);
}

TEST(FixedFrontEnd, EqualOnPhotographsOfGardensPoint) {
  SAILMAP_NEEDS_DATA("gardens_point");
  expect_equal_on("gardens_point", 150);
}

}  // namespace
}  // namespace sailmap::testing
