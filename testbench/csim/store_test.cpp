// The frame store alone, with two and four maps: frame after frame through the same memory.
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
    flags_.front() |= hls::start_of_frame;
    flags_[flags_.size() - 2] |= hls::last_but_one;
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

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] const std::vector<Word>& words() const { return words_; }
  [[nodiscard]] const std::vector<std::uint8_t>& flags() const { return flags_; }

 private:
  int width_, height_;
  std::vector<Word> words_;
  std::vector<std::uint8_t> flags_;
};

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

// Frames back to back, so that the store takes in what comes of the next one while it replays.
template <int Count, int Kind>
class FramesInARow {
 public:
  using Word = hls::lanes_t<Count>;

  void add(const Frame<Count, Kind>& frame) {
    add_part(frame, frame.words().size());
    sizes_.emplace_back(frame.width(), frame.height());
    append(statistics_, frame.statistics());
    append(maps_, frame.words());
    append(replayed_, frame.words());
    append(replayed_, frame.words());
  }
  // The first pixels of a frame that breaks off.
  void add_part(const Frame<Count, Kind>& frame, std::size_t pixels) {
    words_.insert(words_.end(), frame.words().begin(),
                  frame.words().begin() + static_cast<std::ptrdiff_t>(pixels));
    flags_.insert(flags_.end(), frame.flags().begin(),
                  frame.flags().begin() + static_cast<std::ptrdiff_t>(pixels));
  }

  void expect_stored() const {
    StageRun run;
    std::vector<std::uint32_t> statistics;
    std::vector<Word> maps;
    std::vector<Word> replayed;
    auto& in = run.feed(words_);
    auto& in_flags = run.feed(flags_);
    auto& statistics_out = run.take(statistics_.size(), statistics);
    auto& maps_out = run.take(maps_.size(), maps);
    auto& out = run.take(replayed_.size(), replayed);
    for (const auto& [width, height] : sizes_) {
      SAILMAP_STAGE((hls::store<Config, Count, Kind, 0>), in, in_flags, statistics_out, maps_out, out,
                    static_cast<std::uint16_t>(width), static_cast<std::uint16_t>(height));
    }
    run.run();
    EXPECT_EQ(statistics, statistics_);
    EXPECT_EQ(maps, maps_);
    EXPECT_EQ(replayed, replayed_);
  }

 private:
  std::vector<std::pair<int, int>> sizes_;
  std::vector<Word> words_;
  std::vector<std::uint8_t> flags_;
  std::vector<std::uint32_t> statistics_;
  std::vector<Word> maps_;
  std::vector<Word> replayed_;
};

std::mt19937 seeded() {
  const unsigned seed = std::random_device{}();
  std::cout << "seed " << seed << '\n';
  return std::mt19937(seed);
}

template <int Count, int Kind>
void expect_frames_stored() {
  std::mt19937 random = seeded();
  FramesInARow<Count, Kind> in_a_row;
  for (const auto& [width, height] : frames) {
    SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
    const Frame<Count, Kind> frame(width, height, random);
    FramesInARow<Count, Kind> alone;
    alone.add(frame);
    alone.expect_stored();
    in_a_row.add(frame);
  }
  in_a_row.expect_stored();
}

TEST(Store, OfTwoMaps) { expect_frames_stored<2, hls::intensity_kind>(); }
TEST(Store, OfFourMaps) { expect_frames_stored<4, hls::colour_kind>(); }

// Behind the second replay, and no further than to the last pixel: how much, whatever the timing.
TEST(Store, TakesTheNextFrameInWhileItReplays) {
  using Ahead = hls::TakenAhead<Config, 2, hls::orientation_kind, 0>;
  std::mt19937 random = seeded();
  const Frame<2, hls::orientation_kind> frame(100, 66, random);
  const Frame<2, hls::orientation_kind> next(64, 64, random);
  FramesInARow<2, hls::orientation_kind> run;
  run.add(frame);
  run.add_part(next, next.words().size() - 1);
  run.expect_stored();
  EXPECT_EQ(Ahead::pixels, next.words().size() - 1);
}

TEST(Store, ForgetsAFrameThatBrokeOff) {
  std::mt19937 random = seeded();
  const Frame<2, hls::conspicuity_kind> large(256, 256, random);
  const Frame<2, hls::conspicuity_kind> small(64, 64, random);
  for (const std::size_t pixels : {std::size_t{1}, small.words().size() + 10}) {
    FramesInARow<2, hls::conspicuity_kind> broken;
    broken.add(large);
    broken.add_part(large, pixels);
    broken.expect_stored();
    FramesInARow<2, hls::conspicuity_kind> next;
    next.add(small);
    next.add(large);
    next.expect_stored();
  }
}

}  // namespace
}  // namespace sailmap::testing
