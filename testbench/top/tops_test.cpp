// The front end's top as the tools compile it, its stages run one after the other over unbounded streams: the
// same words as the quantised reference.
#include <gtest/gtest.h>

#include <iostream>
#include <random>
#include <vector>

#include "csim/expected.hpp"
#include "csim/frames.hpp"
#include "front_end.hpp"

namespace sailmap::testing {
namespace {

constexpr int beat = top::Config::beat;

template <class T>
std::vector<T> drained(hls::stream<T>& stream) {
  std::vector<T> words;
  while (stream.size() > 0) words.push_back(stream.read());
  return words;
}

csim::FrontEndWords through_top(const csim::Frame& frame) {
  hls::stream<sailmap_pixels> components[3];
  for (std::size_t i = 0; i < frame.rgb.size(); i += 3 * beat) {
    for (std::size_t component = 0; component < 3; ++component) {
      std::uint64_t word = 0;
      for (std::size_t k = 0; k < beat; ++k) {
        word |= static_cast<std::uint64_t>(frame.rgb[i + 3 * k + component]) << (8 * k);
      }
      components[component].write(static_cast<sailmap_pixels>(word));
    }
  }
  hls::stream<std::uint32_t> intensity_maps;
  hls::stream<std::uint64_t> colour_maps;
  hls::stream<std::uint64_t> orientation_maps;
  hls::stream<std::uint64_t> conspicuity_maps;
  hls::stream<std::uint16_t> saliency;
  hls::stream<std::uint32_t> statistics;
  sailmap_front_end(components[0], components[1], components[2], intensity_maps, colour_maps,
                    orientation_maps, conspicuity_maps, saliency, statistics,
                    static_cast<std::uint16_t>(frame.width), static_cast<std::uint16_t>(frame.height));
  for (auto& component : components) EXPECT_EQ(component.size(), 0U) << "pixels left";
  return {drained(intensity_maps),   drained(colour_maps), drained(orientation_maps),
          drained(conspicuity_maps), drained(saliency),    drained(statistics)};
}

TEST(Top, FrameAfterFrameEqualsTheReference) {
  const unsigned seed = std::random_device{}();
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  const std::vector<csim::Frame> frames = {patches_frame(160, 120, random), noise_frame(96, 65, random),
                                           patches_frame(160, 128, random)};
  for (const csim::Frame& frame : frames) {
    const csim::FrontEndWords got = through_top(frame);
    const csim::FrontEndWords want = expected(frame);
    EXPECT_EQ(got.statistics, want.statistics);
    EXPECT_TRUE(got == want) << frame.width << "x" << frame.height;
  }
}

}  // namespace
}  // namespace sailmap::testing
