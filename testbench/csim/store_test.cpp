// The frame store alone, with two, three and four maps: frame after frame through the same memory.
#include "sailmap/hls/store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "sailmap/hls/config.hpp"
#include "stage_run.hpp"

namespace sailmap::testing {
namespace {

using Config = hls::Config<256, 256, 1>;

// Level-0 sizes, smaller ones behind larger ones.
constexpr std::pair<int, int> frames[] = {{64, 64}, {256, 256}, {66, 68}, {72, 68}, {100, 66}, {92, 100}};

template <int Count, int Kind>
class Frame {
 public:
  using Word = hls::lanes_t<Count>;

  Frame(int width, int height, std::mt19937& random) : width_(width), height_(height) {
    words_.resize(
        static_cast<std::size_t>(hls::geometry::base_side(width) * hls::geometry::base_side(height)));
    flags_.resize(words_.size());
    for (std::size_t i = 0; i < words_.size(); ++i) {
      Word word = 0;
      for (int lane = 0; lane < Count; ++lane) word = static_cast<Word>(word << 16 | random() % 0x10000U);
      words_[i] = word;
      flags_[i] = static_cast<std::uint8_t>(random() % (1U << Count));
    }
  }

  // Maximum and m of each lane, by definition.
  std::vector<std::uint32_t> statistics() const {
    std::vector<std::uint32_t> out;
    for (int lane = 0; lane < Count; ++lane) {
      const auto value = [&](std::size_t i) { return static_cast<std::uint16_t>(words_[i] >> (16 * lane)); };
      std::uint32_t maximum = 0;
      for (std::size_t i = 0; i < words_.size(); ++i) maximum = std::max<std::uint32_t>(maximum, value(i));
      std::uint32_t maxima = 0;
      for (std::size_t i = 0; i < words_.size(); ++i)
        maxima += (flags_[i] >> lane & 1U) != 0 && 2U * value(i) > maximum ? 1 : 0;
      out.insert(out.end(), {maximum, maxima});
    }
    return out;
  }

  void expect_stored() const {
    StageRun run;
    std::vector<std::uint32_t> statistics_out;
    std::vector<Word> replayed;
    SAILMAP_STAGE((hls::store<Config, Count, Kind, 0>), run.feed(words_), run.feed(flags_),
                  run.take(2 * Count, statistics_out), run.take(words_.size(), replayed),
                  static_cast<std::uint16_t>(width_), static_cast<std::uint16_t>(height_));
    run.run();
    EXPECT_EQ(statistics_out, statistics());
    EXPECT_EQ(replayed, words_);
  }

 private:
  int width_, height_;
  std::vector<Word> words_;
  std::vector<std::uint8_t> flags_;
};

template <int Count, int Kind>
void expect_frames_stored() {
  const unsigned seed = std::random_device{}();
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  for (const auto& [width, height] : frames) {
    SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
    Frame<Count, Kind>(width, height, random).expect_stored();
  }
}

TEST(Store, OfTwoMaps) { expect_frames_stored<2, hls::intensity_kind>(); }
TEST(Store, OfThreeMaps) { expect_frames_stored<3, hls::conspicuity_kind>(); }
TEST(Store, OfFourMaps) { expect_frames_stored<4, hls::colour_kind>(); }

}  // namespace
}  // namespace sailmap::testing
