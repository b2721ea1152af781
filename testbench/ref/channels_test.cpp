// Spec section 2, against values worked by hand and against the section's own formulae.
#include "sailmap/ref/channels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <set>
#include <string>

#include "planes.hpp"

namespace sailmap {
namespace {

using testing::Image;
using testing::Rgb;

ref::Channels channels_of(const Image& image) { return ref::channels<ref::Exact>(image.view()); }

struct WorkedPixel {
  const char* name;
  Rgb colour;
  double intensity, red, green, blue, yellow;
};

void PrintTo(const WorkedPixel& pixel, std::ostream* out) { *out << pixel.name; }

class WorkedChannels : public ::testing::TestWithParam<WorkedPixel> {};

TEST_P(WorkedChannels, AreThoseOfTheHand) {
  const WorkedPixel& expected = GetParam();
  const ref::Channels c = channels_of(Image(1, 1, expected.colour));
  EXPECT_NEAR(c.intensity(0, 0), expected.intensity, 1e-12);
  EXPECT_NEAR(c.red(0, 0), expected.red, 1e-12);
  EXPECT_NEAR(c.green(0, 0), expected.green, 1e-12);
  EXPECT_NEAR(c.blue(0, 0), expected.blue, 1e-12);
  EXPECT_NEAR(c.yellow(0, 0), expected.yellow, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(
    Colours, WorkedChannels,
    ::testing::Values(WorkedPixel{"black", {0, 0, 0}, 0, 0, 0, 0, 0},
                      WorkedPixel{"white", {255, 255, 255}, 1, 0, 0, 0, 0},
                      WorkedPixel{"red", {255, 0, 0}, 1 / 3.0, 3, 0, 0, 0},
                      WorkedPixel{"green", {0, 255, 0}, 1 / 3.0, 0, 3, 0, 0},
                      WorkedPixel{"blue", {0, 0, 255}, 1 / 3.0, 0, 0, 3, 0},
                      WorkedPixel{"yellow", {255, 255, 0}, 2 / 3.0, 0.75, 0.75, 0, 1.5},
                      WorkedPixel{"cyan", {0, 255, 255}, 2 / 3.0, 0, 0.75, 0.75, 0},
                      // r' = 1.875, g' = 0.9375, b' = 0.1875
                      WorkedPixel{"orange", {200, 100, 20}, 320 / 765.0, 1.3125, 0, 0, 0.75},
                      WorkedPixel{"darkest_with_colour", {77, 0, 0}, 77 / 765.0, 3, 0, 0, 0},
                      WorkedPixel{"brightest_without", {76, 0, 0}, 76 / 765.0, 0, 0, 0, 0}),
    [](const auto& worked) { return std::string(worked.param.name); });

// The section's formulae in r', g', b', where the reference uses their integer form.
TEST(Channels, FollowTheFormulaeAllOverTheCube) {
  constexpr int step = 5;
  constexpr int side = 255 / step + 1;
  const auto colour = [](int x, int y) { return Rgb{x / side * step, x % side * step, y * step}; };
  const ref::Channels c = channels_of(Image::painted(side * side, side, colour));
  double worst = 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side * side; ++x) {
      const auto [red, green, blue] = colour(x, y);
      const double sum = red + green + blue;
      const double scale = sum > 76.5 ? 3 / sum : 0;
      const double r = red * scale;
      const double g = green * scale;
      const double b = blue * scale;
      const auto error = [](double actual, double expected) {
        return std::abs(actual - std::fmax(0, expected));
      };
      worst = std::max({worst, error(c.intensity(x, y), sum / 765), error(c.red(x, y), r - (g + b) / 2),
                        error(c.green(x, y), g - (r + b) / 2), error(c.blue(x, y), b - (r + g) / 2),
                        error(c.yellow(x, y), (r + g) / 2 - std::abs(r - g) / 2 - b)});
    }
  }
  EXPECT_LE(worst, 1e-12);
}

// A shaded surface has one hue: not even rounding may give it contrast, which eq. 1 would blow up.
TEST(Channels, OfOneHueAreEqualAtEveryBrightness) {
  for (const Rgb hue : {Rgb{1, 0, 0}, Rgb{4, 2, 1}, Rgb{5, 3, 2}, Rgb{3, 3, 1}, Rgb{1, 6, 4}}) {
    const int darkest = 77 / (hue.r + hue.g + hue.b) + 1;
    const int brightest = 255 / std::max({hue.r, hue.g, hue.b});
    const Image ramp = Image::painted(brightest - darkest + 1, 1, [&](int x, int) {
      return Rgb{hue.r * (x + darkest), hue.g * (x + darkest), hue.b * (x + darkest)};
    });
    const ref::Channels c = channels_of(ramp);
    for (const auto* channel : {&c.red, &c.green, &c.blue, &c.yellow}) {
      const auto samples = channel->samples();
      EXPECT_EQ(std::set<double>(samples.begin(), samples.end()).size(), 1U) << hue.r << hue.g << hue.b;
    }
  }
}

TEST(Channels, ReadEitherChannelOrderAndAnyStride) {
  // Two BGR pixels a row, rows eight bytes apart.
  const std::uint8_t bytes[] = {20, 100, 200, 0, 0, 255, 9, 9, 255, 0, 0, 0, 255, 0, 9, 9};
  const ref::Channels c = ref::channels<ref::Exact>(ImageView{2, 2, bytes, 8, ChannelOrder::bgr});
  EXPECT_NEAR(c.yellow(0, 0), 0.75, 1e-12);
  EXPECT_NEAR(c.red(1, 0), 3, 1e-12);
  EXPECT_NEAR(c.blue(0, 1), 3, 1e-12);
  EXPECT_NEAR(c.green(1, 1), 3, 1e-12);
}

}  // namespace
}  // namespace sailmap
