// The region from pixels in memory to a record in memory as a network of FIFOs: one region in another.
#include "sailmap/hls/signature_memory.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "expected_signature.hpp"
#include "frames.hpp"
#include "memory_beats.hpp"
#include "sailmap/csim/scheduler.hpp"

namespace sailmap::testing {
namespace {

// Frames back to back, FIFOs of depth 2.
template <class Config>
void expect_records_of_the_reference(const std::vector<csim::Frame>& frames) {
  std::vector<std::vector<hls::memory_beat<Config::beat>>> pixels;
  std::vector<std::vector<std::uint32_t>> records(frames.size(), std::vector<std::uint32_t>(248));
  csim::Scheduler scheduler(2);
  for (const csim::Frame& frame : frames) pixels.push_back(memory_beats<Config::beat>(frame));
  for (std::size_t i = 0; i < frames.size(); ++i) {
    hls::signature_memory_region<Config>(pixels[i].data(), records[i].data(),
                                         static_cast<std::uint16_t>(frames[i].width),
                                         static_cast<std::uint16_t>(frames[i].height), 20, 1U << 14, 10);
  }
  scheduler.run();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const ref::Model model = ref::compute<ref::Quantised>(view(frames[i]));
    EXPECT_EQ(records[i], expected_record(model, frames[i].width, frames[i].height, ref::RegionParameters{}));
  }
}

TEST(SignatureMemoryNetwork, EveryFrameGivesTheReferencesRecord) {
  std::mt19937 random(14);
  const std::vector<csim::Frame> frames = {patches_frame(160, 120, random), noise_frame(96, 65, random),
                                           patches_frame(104, 128, random)};
  expect_records_of_the_reference<hls::Config<160, 128, 1>>(frames);
  expect_records_of_the_reference<hls::Config<160, 128, 8>>(frames);
  expect_records_of_the_reference<hls::Config<160, 128, 8, true>>(frames);
}

}  // namespace
}  // namespace sailmap::testing
