// The signature kernel in C simulation against the quantised reference: every word of every record.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <iostream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <random>

#include "frames.hpp"
#include "sailmap/hls/config.hpp"
#include "sailmap_data.hpp"
#include "signature_run.hpp"

namespace sailmap::testing {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::Gt;

using Config = hls::Config<640, 480, 1>;

std::mt19937 generator() {
  const unsigned seed = std::random_device{}();
  std::cout << "seed " << seed << '\n';
  return std::mt19937(seed);
}

void expect_equal(const std::vector<SignatureCall>& calls) {
  EXPECT_EQ(simulated_records<Config>(calls), expected_records(calls));
}

// Widths of the base level of 16 to 19 pixels more and more: every number of pixels in a row's last word.
TEST(SignatureKernel, FramesOfManySizesBackToBackEqualTheReference) {
  std::mt19937 random = generator();
  std::vector<SignatureCall> calls;
  for (const auto& [width, height] :
       {std::pair{64, 64}, {67, 64}, {69, 81}, {76, 100}, {160, 120}, {73, 64}, {201, 149}, {320, 240}}) {
    calls.push_back(call_of(noise_frame(width, height, random)));
    calls.push_back(call_of(patches_frame(width, height, random)));
  }
  expect_equal(calls);
  EXPECT_THAT(regions_found(simulated_records<Config>(calls)), Contains(20));
}

TEST(SignatureKernel, ConstantFramesHaveNoRegions) {
  std::vector<SignatureCall> calls;
  for (const auto& [r, g, b] : {std::array<std::uint8_t, 3>{0, 0, 0}, {255, 255, 255}, {26, 26, 25}}) {
    calls.push_back(call_of(constant_frame(96, 72, r, g, b)));
  }
  expect_equal(calls);
  EXPECT_THAT(regions_found(simulated_records<Config>(calls)), Each(0));
}

TEST(SignatureKernel, SinglePixelsAndStripesEqualTheReference) {
  std::vector<SignatureCall> calls;
  for (const int x : {0, 1, 45, 94, 95}) {
    for (const int y : {0, 33, 71}) {
      csim::Frame frame = constant_frame(96, 72, 0, 0, 0);
      set_pixel(frame, x, y, 255, 255, 255);
      calls.push_back(call_of(frame));
    }
  }
  for (const int period : {1, 2, 3, 8, 14, 28}) {
    calls.push_back(call_of(stripes_frame(128, 96, period, true)));
    calls.push_back(call_of(stripes_frame(128, 96, period, false)));
  }
  expect_equal(calls);
  EXPECT_THAT(regions_found(simulated_records<Config>(calls)), Contains(Gt(1)));
}

TEST(SignatureKernel, EveryParameterIsObeyed) {
  std::mt19937 random = generator();
  const csim::Frame frame = noise_frame(160, 120, random);
  std::vector<SignatureCall> calls;
  for (const int most : {1, 2, 19, 20}) calls.push_back(call_of(frame, {most, 0.25, 10}));
  for (const double ratio : {0.0, 1.0 / 65536, 0.5, 0.75, 0.90625, 1.0}) {
    calls.push_back(call_of(frame, {20, ratio, 10}));
  }
  for (const int side : {2, 3, 7, 11, 15, 16}) calls.push_back(call_of(frame, {20, 0.25, side}));
  expect_equal(calls);
  const std::vector<int> found = regions_found(simulated_records<Config>(calls));
  EXPECT_EQ(found[0], 1);
  EXPECT_EQ(found[1], 2);
  EXPECT_EQ(found[4], 20);
  EXPECT_LT(found[8], 20) << "regions above 29/32 of the strongest";
}

// Of what a register may hold: 1 to 20 regions, a ratio of up to 1, boxes of 2 to 16 pixels.
TEST(SignatureKernel, ParametersOutOfRangeAreTakenForTheNearest) {
  std::mt19937 random = generator();
  SignatureCall call = call_of(noise_frame(96, 72, random), {0, 2, 0});
  const std::vector<std::uint32_t> least = simulated_records<Config>({call});
  call.parameters = {1, 1, 2};
  EXPECT_EQ(least, call.expected());
  call.parameters = {65535, 0.25, 65535};
  const std::vector<std::uint32_t> most = simulated_records<Config>({call});
  call.parameters = {20, 0.25, 16};
  EXPECT_EQ(most, call.expected());
}

// Saliency of few different values: nearly every arg-max is a tie, within a row, between rows, and after its
// box is gone.
TEST(SignatureKernel, TiesAreThoseOfTheReference) {
  std::mt19937 random = generator();
  std::vector<SignatureCall> calls;
  for (const int values : {1, 2, 3, 10}) {
    for (const int side : {2, 5, 10}) {
      SignatureCall call = call_of(patches_frame(101, 84, random), {20, 0, side});
      std::uniform_int_distribution<int> value(0, values);
      for (double& v : call.model.saliency.samples()) v = value(random) / 16.0;
      calls.push_back(std::move(call));
    }
  }
  // One value everywhere; the highest there is, in the last pixel.
  SignatureCall flat = call_of(patches_frame(101, 84, random));
  for (double& v : flat.model.saliency.samples()) v = 0.5;
  calls.push_back(flat);
  flat.model.saliency(25, 20) = std::ldexp(65535, -14);
  calls.push_back(flat);
  expect_equal(calls);
}

TEST(SignatureKernel, PhotographsEqualTheReference) {
  SAILMAP_NEEDS_DATA("rtabmap_corridor/images");
  SAILMAP_NEEDS_DATA("gardens_point/images");
  std::vector<SignatureCall> calls;
  for (const char* sequence : {"rtabmap_corridor/images", "gardens_point/images"}) {
    std::vector<std::filesystem::path> images;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(data_folder() / sequence)) {
      if (entry.is_regular_file()) images.push_back(entry.path());
    }
    std::sort(images.begin(), images.end());
    for (std::size_t i = 0; i < 3; ++i) {
      cv::Mat image = cv::imread(images.at(i * images.size() / 3).string());
      ASSERT_FALSE(image.empty()) << images[i];
      cv::Mat small;
      cv::resize(image, small, {320, 240}, 0, 0, cv::INTER_AREA);
      cv::cvtColor(small, small, cv::COLOR_BGR2RGB);
      calls.push_back(call_of({320, 240, {small.datastart, small.dataend}}));
    }
  }
  expect_equal(calls);
  EXPECT_THAT(regions_found(simulated_records<Config>(calls)), Each(Gt(5)));
}

}  // namespace
}  // namespace sailmap::testing
