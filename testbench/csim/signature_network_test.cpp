// Front end and signature as one network of FIFOs: pixels in, records out, at every beat; and what its
// signature costs.
#include <gtest/gtest.h>

#include <iostream>
#include <random>
#include <span>
#include <vector>

#include "expected_signature.hpp"
#include "frames.hpp"
#include "sailmap/csim/signature_front_end.hpp"
#include "sailmap/hls/throughput.hpp"

namespace sailmap::testing {
namespace {

using Records = std::vector<std::vector<std::uint32_t>>;

// At FIFOs of depth 2.
template <class Config>
Records through_network(std::span<const csim::Frame> frames) {
  csim::Scheduler scheduler(2);
  return csim::run_signature_front_end<Config>(frames, {20, 1U << 14, 10}, scheduler);
}

Records expected_of(std::span<const csim::Frame> frames) {
  Records records;
  for (const csim::Frame& frame : frames) {
    records.push_back(expected_record(ref::compute<ref::Quantised>(view(frame)), frame.width, frame.height,
                                      ref::RegionParameters{}));
  }
  return records;
}

TEST(SignatureNetwork, EveryBeatAndBufferGivesTheReferencesRecords) {
  const unsigned seed = std::random_device{}();
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  const std::vector<csim::Frame> frames = {patches_frame(160, 120, random), noise_frame(96, 65, random),
                                           constant_frame(64, 64, 9, 9, 9), patches_frame(104, 128, random)};
  const Records want = expected_of(frames);
  EXPECT_EQ((through_network<hls::Config<160, 128, 1>>(frames)), want);
  EXPECT_EQ((through_network<hls::Config<160, 128, 2>>(frames)), want);
  EXPECT_EQ((through_network<hls::Config<160, 128, 4>>(frames)), want);
  EXPECT_EQ((through_network<hls::Config<160, 128, 8>>(frames)), want);
  EXPECT_EQ((through_network<hls::Config<160, 128, 1, true>>(frames)), want);
  EXPECT_EQ((through_network<hls::Config<160, 128, 8, true>>(frames)), want);
}

// By hand, for VGA: a region looks at 120 rows' peaks, passes ten rows of 40 words, sums 100 pixels and
// divides ten times, 25 turns each; a record has 248 words.
TEST(SignatureThroughput, IsWhatTheLoopsSay) {
  EXPECT_EQ(hls::throughput::signature_after_frame(640, 480, 20, 10),
            20 * (120 + 10 * 40 + 10 * 10 + 10 * 25) + 248);
}

// Issue: 20 regions cost no more than the frame's own streaming time. Of VGA at every beat, and of every
// preset.
TEST(SignatureThroughput, TwentyRegionsCostLessThanTheFramesOwnPixels) {
  using namespace hls::throughput;
  for (const int beat : {1, 2, 4, 8}) {
    for (const auto& [width, height] : {std::pair{640, 480}, {1280, 720}, {1920, 1080}, {4096, 4096}}) {
      EXPECT_LE(signature_after_frame(width, height, 20, 10), input(width, height, beat))
          << width << "x" << height << ", " << beat << " pixels a beat";
    }
  }
  // The least that is not so: QVGA in words of eight.
  EXPECT_LE(signature_after_frame(320, 240, 20, 10), input(320, 240, 4));
  EXPECT_GT(signature_after_frame(320, 240, 20, 10), input(320, 240, 8));
}

// At VGA the signature keeps up with a single store at every beat; with two stores and wide beats it is the
// busiest.
TEST(SignatureThroughput, KeepsUpWithASingleStore) {
  using namespace hls::throughput;
  for (const int beat : {1, 2, 4, 8}) {
    EXPECT_EQ(frame_with_signature(640, 480, beat, false, 10), frame(640, 480, beat, false));
  }
  EXPECT_EQ(frame_with_signature(640, 480, 2, true, 10), frame(640, 480, 2, true));
  EXPECT_GT(frame_with_signature(640, 480, 8, true, 10), frame(640, 480, 8, true));
}

}  // namespace
}  // namespace sailmap::testing
