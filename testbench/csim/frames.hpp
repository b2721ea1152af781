// Frames to test with.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>

#include "sailmap/csim/frame.hpp"

namespace sailmap::testing {

inline csim::Frame constant_frame(int width, int height, std::uint8_t r, std::uint8_t g, std::uint8_t b) {
  csim::Frame frame{width, height, {}};
  for (int i = 0; i < width * height; ++i) frame.rgb.insert(frame.rgb.end(), {r, g, b});
  return frame;
}

inline csim::Frame noise_frame(int width, int height, std::mt19937& generator) {
  csim::Frame frame = constant_frame(width, height, 0, 0, 0);
  std::uniform_int_distribution<int> byte(0, 255);
  for (std::uint8_t& value : frame.rgb) value = static_cast<std::uint8_t>(byte(generator));
  return frame;
}

// Rectangles of random place, size and colour: flat areas and hard edges.
inline csim::Frame patches_frame(int width, int height, std::mt19937& generator) {
  csim::Frame frame = constant_frame(width, height, 90, 120, 60);
  const auto draw = [&generator](int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(generator);
  };
  for (int patch = 0; patch < 12; ++patch) {
    const int x0 = draw(0, width - 1);
    const int y0 = draw(0, height - 1);
    const int x1 = std::min(width, x0 + draw(1, width / 2));
    const int y1 = std::min(height, y0 + draw(1, height / 2));
    const std::uint8_t colour[] = {static_cast<std::uint8_t>(draw(0, 255)),
                                   static_cast<std::uint8_t>(draw(0, 255)),
                                   static_cast<std::uint8_t>(draw(0, 255))};
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        for (int c = 0; c < 3; ++c) frame.rgb[static_cast<std::size_t>(3 * (y * width + x) + c)] = colour[c];
      }
    }
  }
  return frame;
}

inline void set_pixel(csim::Frame& frame, int x, int y, std::uint8_t r, std::uint8_t g, std::uint8_t b) {
  const auto at = static_cast<std::size_t>(3 * (y * frame.width + x));
  frame.rgb[at] = r;
  frame.rgb[at + 1] = g;
  frame.rgb[at + 2] = b;
}

// Vertical (or horizontal) stripes, `period` pixels of each colour.
inline csim::Frame stripes_frame(int width, int height, int period, bool vertical) {
  csim::Frame frame = constant_frame(width, height, 0, 0, 0);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if ((vertical ? x : y) / period % 2 == 0) set_pixel(frame, x, y, 255, 255, 0);
    }
  }
  return frame;
}

}  // namespace sailmap::testing
