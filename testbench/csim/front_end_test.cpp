// The whole front end in C simulation against the quantised reference: every word of every stream.
#include "sailmap/csim/front_end.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ctime>
#include <filesystem>
#include <iostream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <random>

#include "expected.hpp"
#include "frames.hpp"
#include "sailmap/csim/simulate.hpp"
#include "sailmap_data.hpp"

namespace sailmap::testing {
namespace {

using csim::Frame;
using csim::FrontEndWords;

std::vector<FrontEndWords> simulated(const std::vector<Frame>& frames, int beat) {
  csim::Scheduler scheduler;
  return csim::simulate(frames, beat, scheduler);
}

void expect_equal(const FrontEndWords& got, const FrontEndWords& want) {
  EXPECT_EQ(got.statistics, want.statistics);
  EXPECT_TRUE(got.intensity_maps == want.intensity_maps) << "intensity maps differ";
  EXPECT_TRUE(got.colour_maps == want.colour_maps) << "colour maps differ";
  EXPECT_TRUE(got.orientation_maps == want.orientation_maps) << "orientation maps differ";
  EXPECT_TRUE(got.conspicuity_maps == want.conspicuity_maps) << "conspicuity maps differ";
  EXPECT_TRUE(got.saliency == want.saliency) << "saliency differs";
}

// Every beat that divides the width.
void expect_equal_at_all_beats(const std::string& what, const Frame& frame) {
  const FrontEndWords want = expected(frame);
  for (const int beat : {1, 2, 4, 8}) {
    if (frame.width % beat != 0) continue;
    SCOPED_TRACE(what + ", " + std::to_string(frame.width) + "x" + std::to_string(frame.height) + ", beat " +
                 std::to_string(beat));
    expect_equal(simulated({frame}, beat)[0], want);
  }
}

// A fresh generator, whose seed the log names.
std::mt19937 generator() {
  const unsigned seed = std::random_device{}();
  std::cout << "seed " << seed << '\n';
  return std::mt19937(seed);
}

TEST(CsimFrontEnd, NoiseAndPatchesEqualTheReference) {
  std::mt19937 random = generator();
  expect_equal_at_all_beats("noise", noise_frame(160, 120, random));
  expect_equal_at_all_beats("patches", patches_frame(160, 120, random));
  expect_equal_at_all_beats("patches", patches_frame(200, 149, random));
}

TEST(CsimFrontEnd, ExtremeFramesEqualTheReference) {
  for (const auto& [r, g, b] :
       {std::array<std::uint8_t, 3>{0, 0, 0}, {255, 255, 255}, {255, 0, 0}, {26, 26, 25}}) {
    expect_equal_at_all_beats("constant", constant_frame(96, 72, r, g, b));
  }
  for (const int x : {0, 1, 45, 94, 95}) {
    for (const int y : {0, 33, 71}) {
      Frame frame = constant_frame(96, 72, 0, 0, 0);
      set_pixel(frame, x, y, 255, 255, 255);
      expect_equal_at_all_beats("single pixel", frame);
    }
  }
  for (const int period : {1, 2, 3, 8, 14, 28}) {
    expect_equal_at_all_beats("vertical stripes", stripes_frame(128, 96, period, true));
    expect_equal_at_all_beats("horizontal stripes", stripes_frame(128, 96, period, false));
  }
}

// Every width and every height from 64 to 100, paired so that all residues of 16 meet.
TEST(CsimFrontEnd, EverySmallSizeEqualsTheReference) {
  std::mt19937 random = generator();
  for (int step = 0; step <= 36; ++step) {
    expect_equal_at_all_beats("noise", noise_frame(64 + step, 64 + 23 * step % 37, random));
    expect_equal_at_all_beats("patches", patches_frame(64 + 17 * step % 37, 64 + step, random));
    expect_equal_at_all_beats("patches", patches_frame(64 + step, 64 + step, random));
  }
}

TEST(CsimFrontEnd, LargerOddSizesEqualTheReference) {
  std::mt19937 random = generator();
  for (const auto& [w, h] :
       {std::pair{257, 199}, {321, 131}, {135, 411}, {64, 513}, {1030, 65}, {402, 303}, {456, 257}}) {
    expect_equal_at_all_beats("patches", patches_frame(w, h, random));
  }
}

// Frames of different size follow each other through one network without a trace.
TEST(CsimFrontEnd, FramesBackToBackEqualTheReference) {
  std::mt19937 random = generator();
  const std::vector<Frame> frames = {noise_frame(96, 64, random),     patches_frame(200, 149, random),
                                     constant_frame(64, 64, 9, 9, 9), patches_frame(64, 200, random),
                                     noise_frame(96, 64, random),     patches_frame(320, 100, random)};
  for (const int beat : {1, 2, 4, 8}) {
    SCOPED_TRACE(beat);
    const std::vector<FrontEndWords> got = simulated(frames, beat);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      SCOPED_TRACE(i);
      expect_equal(got[i], expected(frames[i]));
    }
  }
}

Frame photograph(const std::filesystem::path& file) {
  cv::Mat image = cv::imread(file.string(), cv::IMREAD_COLOR);
  if (image.empty()) throw std::runtime_error(file.string() + ": no image");
  cv::cvtColor(image, image, cv::COLOR_BGR2RGB);
  return {image.cols, image.rows, {image.datastart, image.dataend}};
}

void expect_photographs_equal(const char* sequence) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(data_folder() / sequence / "images")) {
    if (entry.path().extension() == ".jpg" || entry.path().extension() == ".png")
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  ASSERT_FALSE(files.empty());
  for (std::size_t i = 0; i < 3; ++i) {
    const std::filesystem::path& file = files[i * (files.size() - 1) / 2];
    expect_equal_at_all_beats(file.filename().string(), photograph(file));
  }
}

TEST(CsimFrontEnd, GardensPointPhotographsEqualTheReference) {
  SAILMAP_NEEDS_DATA("gardens_point");
  expect_photographs_equal("gardens_point");
}

TEST(CsimFrontEnd, CorridorPhotographsEqualTheReference) {
  SAILMAP_NEEDS_DATA("rtabmap_corridor");
  expect_photographs_equal("rtabmap_corridor");
}

// A configuration whose largest frame is the frame: nothing is indexed beyond its memories.
TEST(CsimFrontEnd, FrameOfTheLargestSizeEqualsTheReference) {
  std::mt19937 random = generator();
  const std::vector<Frame> frames = {patches_frame(104, 99, random), patches_frame(72, 99, random)};
  csim::Scheduler scheduler;
  const auto got = csim::run_front_end<hls::Config<104, 99, 8>>(frames, scheduler);
  for (std::size_t i = 0; i < frames.size(); ++i) expect_equal(got[i], expected(frames[i]));
}

TEST(CsimFrontEnd, DoubleBufferingChangesNoWord) {
  std::mt19937 random = generator();
  std::vector<Frame> frames;
  for (int i = 0; i < 5; ++i) frames.push_back(patches_frame(96 + 8 * (i % 2), 80 - i, random));
  csim::Scheduler scheduler;
  const auto got = csim::run_front_end<hls::Config<128, 96, 4, true>>(frames, scheduler);
  for (std::size_t i = 0; i < frames.size(); ++i) expect_equal(got[i], expected(frames[i]));
}

TEST(CsimFrontEnd, RefusesFramesItDoesNotTake) {
  csim::Scheduler scheduler;
  const std::vector<Frame> odd = {constant_frame(66, 64, 1, 2, 3)};
  EXPECT_THROW(csim::simulate(odd, 4, scheduler), std::invalid_argument);
  EXPECT_THROW(csim::simulate(odd, 3, scheduler), std::invalid_argument);
  const std::vector<Frame> small = {constant_frame(64, 63, 1, 2, 3)};
  EXPECT_THROW(csim::simulate(small, 1, scheduler), std::invalid_argument);
  EXPECT_EQ(simulated(odd, 2).size(), 1U);
}

// At least two VGA frames a second of processor time, which other work on the machine does not take part in;
// the log says how many. A build for debugging is not what one works with.
TEST(CsimFrontEnd, IsFastEnoughToWorkWith) {
  std::mt19937 random = generator();
  const std::vector<Frame> frames(4, patches_frame(640, 480, random));
  const std::clock_t begin = std::clock();
  EXPECT_EQ(simulated(frames, 4).size(), frames.size());
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  const double rate = static_cast<double>(frames.size()) / seconds;
  std::cout << "C simulation: " << rate << " VGA frames a second\n";
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__)
  EXPECT_GE(rate, 2.0);
#endif
}

}  // namespace
}  // namespace sailmap::testing
