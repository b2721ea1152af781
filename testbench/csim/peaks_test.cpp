// Maximum and m of the conspicuity maps found in two passes: against the counts by definition.
#include "sailmap/hls/peaks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "expected.hpp"
#include "sailmap/hls/config.hpp"
#include "stage_run.hpp"

namespace sailmap::testing {
namespace {

using Config = hls::Config<256, 256, 1>;

constexpr int maps_in_all = hls::geometry::conspicuity_maps;

// Three maps of the base level as the stage gets them, once.
struct Maps {
  int width, height;  // of the base level
  std::vector<std::uint64_t> words;
  std::vector<std::uint8_t> flags;

  Maps(int w, int h) : width(w), height(h) {
    words.resize(static_cast<std::size_t>(w * h));
    flags.resize(words.size());
  }
  [[nodiscard]] std::uint32_t value(std::size_t i, int lane) const {
    return words[i] >> (16 * lane) & 0xffffU;
  }

  [[nodiscard]] std::vector<std::uint32_t> statistics() const {
    std::vector<std::uint32_t> out;
    for (int lane = 0; lane < maps_in_all; ++lane) {
      std::uint32_t maximum = 0;
      for (std::size_t i = 0; i < words.size(); ++i) maximum = std::max(maximum, value(i, lane));
      std::uint32_t maxima = 0;
      for (std::size_t i = 0; i < words.size(); ++i)
        maxima += (flags[i] >> lane & 1U) != 0 && 2 * value(i, lane) > maximum ? 1 : 0;
      out.insert(out.end(), {maximum, maxima});
    }
    return out;
  }
};

void expect_found(const Maps& maps) {
  StageRun run;
  std::vector<std::uint32_t> statistics;
  std::vector<std::uint64_t> maps_out;
  std::vector<std::uint64_t> out;
  SAILMAP_STAGE((hls::peaks<Config>), run.feed(twice(maps.words)), run.feed(twice(maps.flags)),
                run.take(2 * maps_in_all, statistics), run.take(maps.words.size(), maps_out),
                run.take(maps.words.size(), out), static_cast<std::uint16_t>(4 * maps.width),
                static_cast<std::uint16_t>(4 * maps.height));
  run.run();
  EXPECT_EQ(statistics, maps.statistics());
  EXPECT_EQ(maps_out, maps.words);
  EXPECT_EQ(out, maps.words);
}

// Values up to `largest`, every fourth pixel flagged where none of them are neighbours: as many as can be.
Maps most_maxima(int w, int h, std::uint32_t largest, std::mt19937& random) {
  Maps maps(w, h);
  for (std::size_t i = 0; i < maps.words.size(); ++i) {
    for (int lane = 0; lane < maps_in_all; ++lane)
      maps.words[i] |= std::uint64_t{random() % (largest + 1)} << (16 * lane);
    const auto x = static_cast<int>(i) % w;
    const auto y = static_cast<int>(i) / w;
    maps.flags[i] = x % 2 == 0 && y % 2 == 0 ? 7 : 0;
  }
  return maps;
}

TEST(Peaks, AsManyMaximaAsCanBe) {
  const unsigned seed = std::random_device{}();
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  for (const auto& [w, h] : {std::pair{16, 16}, {64, 64}, {17, 25}, {63, 16}}) {
    for (const std::uint32_t largest : {0U, 1U, 5U, 1000U, 65535U}) {
      SCOPED_TRACE(std::to_string(w) + "x" + std::to_string(h) + " up to " + std::to_string(largest));
      expect_found(most_maxima(w, h, largest, random));
    }
  }
}

// Those before it count or not by a maximum that only the last pixel has.
TEST(Peaks, TheMaximumComesLast) {
  Maps maps(17, 17);
  for (std::size_t i = 0; i < maps.words.size(); i += 2) {
    if (i / 17 % 2 != 0) continue;
    maps.words[i] = 0x0000000100020003U * (i + 1);
    maps.flags[i] = 7;
  }
  maps.words.back() = 0x000001f404b00384U;  // 900, 1200 and 500, where 867, 578 and 289 are the largest else
  EXPECT_EQ(maps.statistics()[3], 1U);
  expect_found(maps);
}

}  // namespace
}  // namespace sailmap::testing
