// Synthetic images for the number tests: what drives every point to its ends, and what photographs never
// show.
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "sailmap/ref/plane.hpp"

namespace sailmap::testing {

// Owns its pixels, r, g, b.
struct RgbImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;

  [[nodiscard]] ImageView view() const {
    return {width, height, pixels.data(), std::ptrdiff_t{3} * width, ChannelOrder::rgb};
  }
};

using Rgb = ImageView::Rgb;

inline RgbImage image_of(int width, int height, const std::function<Rgb(int x, int y)>& colour) {
  RgbImage out{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto [r, g, b] = colour(x, y);
      for (const int channel : {r, g, b}) out.pixels.push_back(static_cast<std::uint8_t>(channel));
    }
  }
  return out;
}

constexpr Rgb black = {0, 0, 0};
constexpr Rgb white = {255, 255, 255};

inline RgbImage noise(int width, int height, unsigned seed, int most = 255) {
  std::mt19937 random(seed);
  const auto level = [&random, most] { return static_cast<int>(random() % static_cast<unsigned>(most + 1)); };
  return image_of(width, height, [&](int, int) { return Rgb{level(), level(), level()}; });
}

// A side x side square in the middle.
inline RgbImage square(int image_side, int side, Rgb inside, Rgb outside) {
  const int from = (image_side - side) / 2;
  const auto in = [&](int v) { return v >= from && v < from + side; };
  return image_of(image_side, image_side, [&](int x, int y) { return in(x) && in(y) ? inside : outside; });
}

// Stripes of `width` pixels across the direction (dx, dy).
inline RgbImage stripes(int image_side, int width, int dx, int dy) {
  return image_of(image_side, image_side, [&](int x, int y) {
    return (x * dx + y * dy + 4 * image_side) / width % 2 == 0 ? black : white;
  });
}

inline std::vector<RgbImage> extreme_images() {
  std::vector<RgbImage> images;
  for (const int side : {4, 8, 12, 16, 24, 32}) {
    images.push_back(square(192, side, white, black));
    images.push_back(square(192, side, black, white));
    images.push_back(square(192, side, {255, 0, 0}, black));
    images.push_back(square(192, side, {0, 255, 0}, black));
    images.push_back(square(192, side, {0, 0, 255}, black));
    images.push_back(square(192, side, {255, 255, 0}, black));
    images.push_back(square(192, side, {255, 120, 0}, black));
  }
  for (const int width : {14, 20, 28, 40, 56, 96}) {
    images.push_back(stripes(192, width, 1, 0));
    images.push_back(stripes(192, width, 0, 1));
    images.push_back(stripes(192, width, 1, 1));
    images.push_back(stripes(192, width, 1, -1));
  }
  return images;
}

}  // namespace sailmap::testing
