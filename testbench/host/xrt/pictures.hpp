// Images to send through a device, and the maps or signatures that must come back.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "fixed/maps_equal.hpp"
#include "frontends/xrt/kernel_interface.hpp"
#include "sailmap/frontend.hpp"
#include "sailmap/signature.hpp"

namespace sailmap::fpga {

// For GoogleTest's messages.
inline void PrintTo(const KernelInterface& kernel, std::ostream* out) { *out << kernel.name; }

}  // namespace sailmap::fpga

namespace sailmap::testing {

struct Picture {
  int width;
  int height;
  std::vector<std::uint8_t> bgr;

  [[nodiscard]] ImageView view() const { return {width, height, bgr.data(), 3L * width, ChannelOrder::bgr}; }
};

// Rectangles of random place, size and colour; no two seeds look alike.
inline Picture picture(unsigned seed, int width = 96, int height = 72) {
  std::mt19937 random(seed);
  const auto draw = [&](int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(random);
  };
  Picture picture{width, height,
                  std::vector<std::uint8_t>(3UL * static_cast<std::size_t>(width * height), 90)};
  for (int patch = 0; patch < 12; ++patch) {
    const int x0 = draw(0, width - 8);
    const int y0 = draw(0, height - 8);
    const int side = draw(4, 30);
    for (int y = y0; y < std::min(height, y0 + side); ++y) {
      for (int x = x0; x < std::min(width, x0 + side); ++x) {
        for (int c = 0; c < 3; ++c) {
          picture.bgr[static_cast<std::size_t>(3 * (y * width + x) + c)] =
              static_cast<std::uint8_t>(50 * c + 13 * patch + static_cast<int>(seed % 40));
        }
      }
    }
  }
  return picture;
}

// What the CPU says, which no kernel code takes part in.
inline Maps expected_maps(const Picture& picture) {
  Maps maps;
  make_frontend("fixed")->compute(picture.view(), maps);
  return maps;
}

inline void expect_same(const Maps& got, const Maps& want) { EXPECT_EQ(difference(got, want), ""); }

inline RegionConfig on_chip() {
  RegionConfig config;
  config.signature = SignatureMaker::chip;
  return config;
}

// What a front end says of an image where its card has one kernel: that one's output, the other empty.
struct Answer {
  Maps maps;
  Signature signature;
};

inline Answer ask(Frontend& frontend, const Picture& picture, const fpga::KernelInterface& kernel) {
  Answer answer;
  if (kernel == fpga::maps_kernel) {
    frontend.compute(picture.view(), answer.maps);
  } else {
    Maps maps;  // a fallback has them
    frontend.describe(picture.view(), on_chip(), maps, answer.signature);
  }
  return answer;
}

// What the CPU says, which no kernel code takes part in.
inline Answer expected_answer(const Picture& picture, const fpga::KernelInterface& kernel) {
  return ask(*make_frontend("fixed"), picture, kernel);
}

inline void expect_same(const Answer& got, const Answer& want) {
  expect_same(got.maps, want.maps);
  EXPECT_TRUE(got.signature == want.signature);
}

// The name of a test for each kernel.
inline std::string kernel_word(const ::testing::TestParamInfo<fpga::KernelInterface>& kernel) {
  return kernel.param == fpga::maps_kernel ? "maps" : "signature";
}

}  // namespace sailmap::testing
