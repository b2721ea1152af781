// The AMD wrapper: AXI4-Stream video with every kind of fault, of which the next good frame knows nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "axi.hpp"
#include "csim/expected.hpp"
#include "csim/frames.hpp"

namespace sailmap::testing {
namespace {

namespace status = hls::status;
constexpr int beat_pixels = top::Config::beat;
constexpr int width = 96;
constexpr int height = 72;
using Beat = hls::video_beat<beat_pixels>;
using Line = std::vector<Beat>;
using Status = std::array<std::uint32_t, status::words>;

// The lines of a frame as a camera sends them.
std::vector<Line> lines_of(const csim::Frame& frame) {
  std::vector<Line> lines;
  std::size_t at = 0;
  for (int y = 0; y < frame.height; ++y) {
    Line line(static_cast<std::size_t>(frame.width / beat_pixels));
    for (Beat& beat : line) {
      for (int pixel = 0; pixel < beat_pixels; ++pixel, at += 3) {
        for (int bit = 0; bit < 8; ++bit) {
          beat.data.set(24 * pixel + bit, (frame.rgb[at + 1] >> bit & 1) != 0);      // green
          beat.data.set(24 * pixel + 8 + bit, (frame.rgb[at + 2] >> bit & 1) != 0);  // blue
          beat.data.set(24 * pixel + 16 + bit, (frame.rgb[at] >> bit & 1) != 0);     // red
        }
      }
    }
    line.back().last = 1;
    lines.push_back(line);
  }
  lines.front().front().user = 1;
  return lines;
}

class Video : public ::testing::Test {
 protected:
  void send(const std::vector<Line>& lines) {
    for (const Line& line : lines) {
      for (const Beat& beat : line) video.write(beat);
    }
  }

  template <class Word, int Bits>
  std::vector<Word> packets(hls::stream<hls::map_beat<Bits>>& stream, std::size_t row) {
    std::vector<Word> words;
    while (stream.size() > 0) {
      const auto beat = stream.read();
      EXPECT_EQ(beat.user.to_uint(), words.empty() ? 1U : 0U);
      words.push_back(static_cast<Word>(beat.data.to_uint64()));
      EXPECT_EQ(beat.last.to_uint(), words.size() % row == 0 ? 1U : 0U);
      EXPECT_EQ(beat.keep.to_uint(), (1U << (Bits / 8)) - 1);
    }
    return words;
  }

  // One run of the wrapper: the maps of a frame. Adds to `counts` what the status register gained.
  csim::FrontEndWords take() {
    Status now = last;
    sailmap_axi(video, intensity_maps, colour_maps, orientation_maps, conspicuity_maps, saliency, statistics,
                now.data(), width, height);
    for (std::size_t i = 0; i < now.size(); ++i) counts[i] += now[i] - last[i];
    last = now;
    constexpr std::size_t row = hls::geometry::base_side(width);
    return {packets<std::uint32_t>(intensity_maps, row),
            packets<std::uint64_t>(colour_maps, row),
            packets<std::uint64_t>(orientation_maps, row),
            packets<std::uint64_t>(conspicuity_maps, row),
            packets<std::uint16_t>(saliency, row),
            packets<std::uint32_t>(statistics, hls::statistics_words)};
  }

  void SetUp() override {
    // The register counts since reset, and another test may have run before: learn where it stands with a
    // good frame.
    send(lines_of(constant_frame(width, height, 0, 0, 0)));
    take();
    counts = {};
  }

  void expect_counts(const std::vector<int>& bumped) {
    Status want{};
    for (const int index : bumped) ++want[static_cast<std::size_t>(index)];
    EXPECT_EQ(counts, want);
  }

  std::mt19937 random{7};
  csim::Frame first = patches_frame(width, height, random);
  csim::Frame second = noise_frame(width, height, random);
  hls::stream<Beat> video;
  hls::stream<hls::map_beat<32>> intensity_maps;
  hls::stream<hls::map_beat<64>> colour_maps;
  hls::stream<hls::map_beat<64>> orientation_maps;
  hls::stream<hls::map_beat<64>> conspicuity_maps;
  hls::stream<hls::map_beat<16>> saliency;
  hls::stream<hls::map_beat<32>> statistics;
  Status last{};
  Status counts{};
};

void blacken(csim::Frame& frame, int x0, int y0, int x1, int y1) {
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) set_pixel(frame, x, y, 0, 0, 0);
  }
}

TEST_F(Video, GoodFramesComeThrough) {
  send(lines_of(first));
  send(lines_of(second));
  EXPECT_TRUE(take() == expected(first));
  EXPECT_TRUE(take() == expected(second));
  expect_counts({status::frames, status::frames});
  EXPECT_EQ(video.size(), 0U);
}

TEST_F(Video, AShortLineEndsBlack) {
  std::vector<Line> lines = lines_of(first);
  lines[10].resize(5);
  lines[10].back().last = 1;
  send(lines);
  send(lines_of(second));
  blacken(first, 5 * beat_pixels, 10, width, 11);
  EXPECT_TRUE(take() == expected(first));
  EXPECT_TRUE(take() == expected(second));
  expect_counts({status::frames, status::frames, status::bad_frames, status::short_lines});
}

TEST_F(Video, ALongLineIsCut) {
  std::vector<Line> lines = lines_of(first);
  lines[5].back().last = 0;
  lines[5].push_back(Beat());
  lines[5].push_back(Beat());
  lines[5].back().last = 1;
  send(lines);
  send(lines_of(second));
  EXPECT_TRUE(take() == expected(first));
  EXPECT_TRUE(take() == expected(second));
  expect_counts({status::frames, status::frames, status::bad_frames, status::long_lines});
}

TEST_F(Video, AShortFrameEndsBlackAndTheNextIsWhole) {
  std::vector<Line> lines = lines_of(first);
  lines.resize(50);
  send(lines);
  send(lines_of(second));
  blacken(first, 0, 50, width, height);
  EXPECT_TRUE(take() == expected(first));
  EXPECT_TRUE(take() == expected(second));
  expect_counts({status::frames, status::frames, status::bad_frames, status::short_frames});
  EXPECT_EQ(video.size(), 0U);
}

TEST_F(Video, AFrameThatBreaksOffWithinALineEndsBlackAndTheNextIsWhole) {
  std::vector<Line> lines = lines_of(first);
  lines.resize(31);
  lines[30].resize(4);  // without TLAST
  send(lines);
  send(lines_of(second));
  blacken(first, 4 * beat_pixels, 30, width, 31);
  blacken(first, 0, 31, width, height);
  EXPECT_TRUE(take() == expected(first));
  EXPECT_TRUE(take() == expected(second));
  expect_counts({status::frames, status::frames, status::bad_frames, status::short_frames});
}

TEST_F(Video, LinesAfterTheLastAreDropped) {
  std::vector<Line> lines = lines_of(first);
  lines.insert(lines.end(), {lines[3], lines[4]});
  send(lines);
  send(lines_of(second));
  EXPECT_TRUE(take() == expected(first));
  EXPECT_TRUE(take() == expected(second));
  expect_counts({status::frames, status::frames, status::long_frames});
}

TEST_F(Video, AFrameWithoutStartIsDropped) {
  std::vector<Line> lines = lines_of(first);
  lines.front().front().user = 0;
  send(lines);
  send(lines_of(second));
  EXPECT_TRUE(take() == expected(second));
  expect_counts({status::frames, status::missing_starts});
}

TEST_F(Video, ASizeItDoesNotTakeIsRefused) {
  Status now = last;
  for (const auto& [w, h] : {std::pair{63, 72}, {96, 481}, {648, 72}}) {
    sailmap_axi(video, intensity_maps, colour_maps, orientation_maps, conspicuity_maps, saliency, statistics,
                now.data(), static_cast<std::uint16_t>(w), static_cast<std::uint16_t>(h));
  }
  EXPECT_EQ(now[status::refused] - last[status::refused], 3U);
  EXPECT_EQ(saliency.size(), 0U);
}

}  // namespace
}  // namespace sailmap::testing
