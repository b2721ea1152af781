// The whole reference on flat and extreme images: zero where it must be, and in the ranges the spec implies.
#include "sailmap/ref/model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "planes.hpp"

namespace sailmap {
namespace {

using testing::Image;
using testing::is_zero;
using testing::Rgb;

ref::Model compute(const Image& image) { return ref::compute<ref::Exact>(image.view()); }

constexpr std::size_t first_colour = 2;
constexpr std::size_t first_orientation = 6;

class FlatImage : public ::testing::TestWithParam<Rgb> {};

TEST_P(FlatImage, HasNothingSalient) {
  const ref::Model model = compute(Image(101, 67, GetParam()));
  EXPECT_TRUE(std::ranges::all_of(model.features, is_zero));
  EXPECT_TRUE(
      std::ranges::all_of(model.feature_statistics, [](auto stats) { return stats == MapStatistics{}; }));
  EXPECT_TRUE(std::ranges::all_of(model.conspicuities, is_zero));
  EXPECT_TRUE(is_zero(model.saliency));
}

std::string name_of(const ::testing::TestParamInfo<Rgb>& colour) {
  const auto& [r, g, b] = colour.param;
  return std::to_string(r) + '_' + std::to_string(g) + '_' + std::to_string(b);
}

INSTANTIATE_TEST_SUITE_P(Colours, FlatImage,
                         ::testing::Values(Rgb{0, 0, 0}, Rgb{255, 255, 255}, Rgb{128, 128, 128}, Rgb{1, 1, 1},
                                           Rgb{255, 0, 0}, Rgb{0, 255, 0}, Rgb{0, 0, 255}, Rgb{255, 255, 0},
                                           Rgb{25, 26, 26}, Rgb{7, 201, 93}),
                         name_of);

// Grey has no colour; one hue under changing light has no colour contrast; both have intensity contrast.
TEST(ColourlessContrast, LeavesTheColourMapsZero) {
  for (const Rgb hue : {Rgb{1, 1, 1}, Rgb{1, 0, 0}, Rgb{4, 2, 1}, Rgb{5, 3, 2}}) {
    const int darkest = 77 / (hue.r + hue.g + hue.b) + 1;
    const int steps = 255 / std::max({hue.r, hue.g, hue.b}) - darkest + 1;
    const ref::Model model = compute(Image::painted(128, 96, [&](int x, int y) {
      const int light = darkest + (x * x + 3 * y) % steps;
      return Rgb{hue.r * light, hue.g * light, hue.b * light};
    }));
    for (std::size_t i = first_colour; i < first_orientation; ++i)
      EXPECT_TRUE(is_zero(model.features[i])) << i;
    EXPECT_TRUE(is_zero(model.conspicuities[1]));
    EXPECT_GT(testing::largest(model.features[0]), 0.01);
  }
}

// Least and greatest values that the spec's formulae allow. Contrast: a level's value at most, for two radii
// at each of three levels; Gabor energy: at most 1 (see orientation_test); eq. 1: at most 1; S: 3.
struct Range {
  double feature, conspicuity;
};

constexpr Range range_of(std::size_t feature) {
  constexpr double colour_maximum = 3;
  if (feature < first_colour) return {3 * 2 * 1, 2};
  if (feature == 5) return {3 * 2 * colour_maximum / 2, 4};
  if (feature < first_orientation) return {3 * 2 * colour_maximum, 4};
  return {3 * 1, 4};
}

void expect_in_range(const Plane<double>& map, double maximum) {
  for (const double v : map.samples()) {
    ASSERT_TRUE(std::isfinite(v));
    ASSERT_GE(v, 0);
    ASSERT_LE(v, maximum);
  }
}

void expect_in_ranges(const Image& image) {
  const ref::Channels channels = ref::channels<ref::Exact>(image.view());
  expect_in_range(channels.intensity, 1);
  for (const auto* channel : {&channels.red, &channels.green, &channels.blue}) expect_in_range(*channel, 3);
  expect_in_range(channels.yellow, 1.5);

  const ref::Model model = compute(image);
  for (std::size_t i = 0; i < model.features.size(); ++i) {
    expect_in_range(model.features[i], range_of(i).feature);
    EXPECT_EQ(model.feature_statistics[i].maxima > 0, model.feature_statistics[i].maximum > 0);
  }
  expect_in_range(model.conspicuities[0], range_of(0).conspicuity);
  expect_in_range(model.conspicuities[1], range_of(first_colour).conspicuity);
  expect_in_range(model.conspicuities[2], range_of(first_orientation).conspicuity);
  expect_in_range(model.saliency, 3);
  EXPECT_GT(testing::largest(model.saliency), 0);
}

constexpr Rgb black{0, 0, 0};
constexpr Rgb white{255, 255, 255};

TEST(ExtremeImage, SingleBrightPixelStaysInRange) {
  for (const cv::Point at : {cv::Point(0, 0), cv::Point(40, 40), cv::Point(41, 43), cv::Point(100, 66)}) {
    for (const Rgb colour : {white, Rgb{255, 0, 0}, Rgb{255, 255, 0}, Rgb{0, 0, 255}}) {
      Image image(101, 67);
      image.set(at.x, at.y, colour);
      expect_in_ranges(image);
    }
  }
}

TEST(ExtremeImage, CheckerboardStaysInRange) {
  for (const int period : {4, 7, 16, 28, 64}) {
    expect_in_ranges(Image::painted(
        128, 97, [period](int x, int y) { return (x / period + y / period) % 2 == 0 ? black : white; }));
    expect_in_ranges(Image::painted(128, 97, [period](int x, int y) {
      return (x / period + y / period) % 2 == 0 ? Rgb{255, 255, 0} : Rgb{0, 0, 255};
    }));
  }
}

TEST(ExtremeImage, StripesStayInRange) {
  for (const int period : {4, 7, 14, 28, 56}) {
    expect_in_ranges(
        Image::painted(127, 64, [period](int x, int) { return x / period % 2 == 0 ? black : white; }));
    expect_in_ranges(Image::painted(64, 127, [period](int, int y) {
      return y / period % 2 == 0 ? Rgb{0, 255, 0} : Rgb{255, 0, 0};
    }));
  }
}

TEST(ExtremeImage, NoiseStaysInRange) {
  expect_in_ranges(Image::noise(101, 67, 1));
  expect_in_ranges(
      Image::painted(96, 96, [](int x, int y) { return (x * 7 + y * 13) % 11 == 0 ? white : black; }));
}

TEST(Model, HasMapsOfBaseLevelSize) {
  const ref::Model model = compute(Image::noise(101, 67, 1));
  for (const auto& map : model.features) EXPECT_EQ(cv::Size(map.width(), map.height()), cv::Size(26, 17));
  for (const auto& map : model.conspicuities)
    EXPECT_EQ(cv::Size(map.width(), map.height()), cv::Size(26, 17));
  EXPECT_EQ(cv::Size(model.saliency.width(), model.saliency.height()), cv::Size(26, 17));
}

TEST(Model, FindsTheRedBallOnTheLawn) {
  const ref::Model model = compute(Image::painted(160, 120, [](int x, int y) {
    return std::hypot(x - 112, y - 40) < 8 ? Rgb{220, 30, 30} : Rgb{40, 140, 50};
  }));
  const auto samples = model.saliency.samples();
  const auto best = static_cast<int>(std::ranges::max_element(samples) - samples.begin());
  const cv::Point peak(best % model.saliency.width(), best / model.saliency.width());
  EXPECT_LE(cv::norm(peak - cv::Point(112, 40) / 4), 1.5) << peak;
  EXPECT_GT(model.feature_statistics[4].maximum, model.feature_statistics[2].maximum)
      << "red pops out, not green";
}

class ImageOutsideTheSizes : public ::testing::TestWithParam<cv::Size> {};

TEST_P(ImageOutsideTheSizes, IsRefused) {
  const Image image(GetParam().width, GetParam().height);
  EXPECT_THROW(compute(image), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Sizes, ImageOutsideTheSizes,
                         ::testing::Values(cv::Size(63, 64), cv::Size(64, 63), cv::Size(0, 0),
                                           cv::Size(4097, 64), cv::Size(64, 4097)));

}  // namespace
}  // namespace sailmap
