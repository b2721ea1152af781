// What the tests of the tops between memory and memory share: a frame as they read it, and memory that shows
// what was written.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "csim/memory_beats.hpp"
#include "memory_pixels.hpp"

namespace sailmap::testing {

using Config = top::Config;
using Report = std::array<std::uint32_t, SAILMAP_REPORT_WORDS>;
constexpr std::uint32_t untouched = 0xa5a5a5a5;

inline std::vector<sailmap_memory_beat> beats_of(const csim::Frame& frame) {
  return memory_beats<Config::beat>(frame);
}

// The words of a port: these, and nothing behind them.
template <class Word>
void expect_words(const std::vector<Word>& got, const std::vector<Word>& want) {
  ASSERT_LT(want.size(), got.size());
  const auto end = got.begin() + static_cast<std::ptrdiff_t>(want.size());
  EXPECT_TRUE(std::equal(want.begin(), want.end(), got.begin()));
  EXPECT_TRUE(std::all_of(end, got.end(), [](Word word) { return word == static_cast<Word>(untouched); }));
}

// Sizes, width and height, that the front end of this configuration does not take.
inline std::vector<std::pair<std::uint32_t, std::uint32_t>> refused_sizes() {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sizes = {
      {0, 0},  {63, 64},          {64, 63},         {Config::max_width + 8, 64}, {64, Config::max_height + 1},
      {64, 0}, {0x10040U, 0x40U}, {64, 0x80000040U}};
  if (Config::beat > 1) sizes.emplace_back(64 + Config::beat / 2, 64);
  return sizes;
}

}  // namespace sailmap::testing
