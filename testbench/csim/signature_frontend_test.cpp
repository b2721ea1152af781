// The signature on the chip behind the interface the host sees: every fixed-point front end gives the
// kernel's signature, and what the kernel does not do is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "expected_signature.hpp"
#include "frames.hpp"
#include "frontends/signature_record.hpp"
#include "sailmap/error.hpp"
#include "sailmap/frontend.hpp"

namespace sailmap::testing {
namespace {

using ::testing::HasSubstr;

RegionConfig on_chip() {
  RegionConfig config;
  config.signature = SignatureMaker::chip;
  return config;
}

Signature described(std::string_view frontend, const csim::Frame& frame, const RegionConfig& regions) {
  Maps maps;
  Signature signature;
  make_frontend(frontend)->describe(view(frame), regions, maps, signature);
  return signature;
}

// The reference's regions, as the host keeps them.
Signature expected_of(const csim::Frame& frame, const RegionConfig& config) {
  const ref::Model model = ref::compute<ref::Quantised>(view(frame));
  Signature signature{frame.width, frame.height, {}};
  for (const ref::SalientRegion& region : ref::salient_regions<ref::Quantised>(
           model, {config.max_regions, config.stop_ratio, config.box_side})) {
    Region& out = signature.regions.emplace_back();
    out.x = static_cast<std::int16_t>(4 * region.x);
    out.y = static_cast<std::int16_t>(4 * region.y);
    out.saliency = static_cast<float>(region.saliency);
    for (std::size_t i = 0; i < feature_count; ++i) {
      out.descriptor[i] = static_cast<float>(region.descriptor[i]);
    }
  }
  return signature;
}

TEST(SignatureFrontend, EveryFixedPointFrontEndGivesTheReferencesSignature) {
  std::mt19937 random(5);
  RegionConfig other = on_chip();
  other.max_regions = 7;
  other.stop_ratio = 0.125;
  other.box_side = 13;
  for (const csim::Frame& frame :
       {patches_frame(160, 120, random), noise_frame(101, 67, random), constant_frame(64, 64, 3, 3, 3)}) {
    for (const RegionConfig& config : {on_chip(), other}) {
      const Signature want = expected_of(frame, config);
      for (const char* frontend : {"csim", "fixed", "quantised"}) {
        EXPECT_TRUE(described(frontend, frame, config) == want) << frontend << " at " << frame.width;
      }
    }
  }
}

// The same places, the same saliency; descriptors that differ, but by little.
TEST(SignatureFrontend, ChipAndHostDifferInTheLastBitsOfDescriptors) {
  std::mt19937 random(6);
  const csim::Frame frame = patches_frame(320, 240, random);
  const Signature chip = described("fixed", frame, on_chip());
  const Signature host = described("fixed", frame, {});
  ASSERT_EQ(chip.regions.size(), host.regions.size());
  bool differ = false;
  for (std::size_t r = 0; r < host.regions.size(); ++r) {
    EXPECT_EQ(chip.regions[r].x, host.regions[r].x);
    EXPECT_EQ(chip.regions[r].y, host.regions[r].y);
    EXPECT_EQ(chip.regions[r].saliency, host.regions[r].saliency);
    for (std::size_t i = 0; i < feature_count; ++i) {
      EXPECT_NEAR(chip.regions[r].descriptor[i], host.regions[r].descriptor[i], 1e-4);
      differ = differ || chip.regions[r].descriptor[i] != host.regions[r].descriptor[i];
    }
  }
  EXPECT_TRUE(differ) << "the chip's numbers are the host's: was the kernel asked?";
}

std::string refusal(const RegionConfig& config, std::string_view frontend = "fixed") {
  try {
    check_signature(frontend, config);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(SignatureFrontend, WhatTheKernelDoesNotDoIsRefused) {
  EXPECT_EQ(refusal(on_chip()), "");
  EXPECT_EQ(refusal({}, "reference"), "");
  EXPECT_THAT(refusal(on_chip(), "reference"), HasSubstr("'reference' computes in floating point"));
  RegionConfig config = on_chip();
  config.inhibition = Inhibition::gaussian;
  EXPECT_THAT(refusal(config), HasSubstr("inhibition"));
  config = on_chip();
  config.descriptor = DescriptorKind::background;
  EXPECT_THAT(refusal(config), HasSubstr("eq. 3-4"));
  config = on_chip();
  config.describe_place = true;
  EXPECT_THAT(refusal(config), HasSubstr("method context"));
  config = on_chip();
  config.max_regions = 21;
  EXPECT_THAT(refusal(config), HasSubstr("max_regions must be 1 to 20"));
  config = on_chip();
  config.box_side = 17;
  EXPECT_THAT(refusal(config), HasSubstr("box_side must be 2 to 16"));
  config = on_chip();
  config.stop_ratio = 0.3;
  EXPECT_THAT(refusal(config), HasSubstr("multiple of 1/65536, such as 0.3000030517578125"));
  config.stop_ratio = 0.3000030517578125;
  EXPECT_EQ(refusal(config), "");
}

TEST(SignatureFrontend, MapsOfRealNumbersAreRefused) {
  std::mt19937 random(7);
  const csim::Frame frame = patches_frame(64, 64, random);
  EXPECT_THROW(described("reference", frame, on_chip()), Error);
}

TEST(SignatureRecord, ADamagedOneIsRefused) {
  std::mt19937 random(8);
  const csim::Frame frame = patches_frame(96, 80, random);
  const std::vector<std::uint32_t> good =
      expected_record(ref::compute<ref::Quantised>(view(frame)), 96, 80, ref::RegionParameters{});
  const ChipParameters asked = {20, 1U << 14, 10};
  EXPECT_TRUE(signature_of_record(good, 96, 80, asked) == expected_of(frame, on_chip()));
  const auto fault = [&](std::size_t word, std::uint32_t value) -> std::string {
    std::vector<std::uint32_t> record = good;
    record[word] = value;
    try {
      signature_of_record(record, 96, 80, asked);
    } catch (const Error& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_THAT(fault(0, 0x534d0002), HasSubstr("first word"));
  EXPECT_THAT(fault(1, 64 + 65536 * 64), HasSubstr("frame of 64x64"));
  EXPECT_THAT(fault(2, 21), HasSubstr("21 regions"));
  for (const std::size_t parameter : {3U, 4U, 5U}) {
    EXPECT_THAT(fault(parameter, good[parameter] - 1), HasSubstr("other parameters")) << parameter;
  }
  EXPECT_THAT(fault(8, 96), HasSubstr("region 0 lies outside"));
  EXPECT_THROW(signature_of_record(std::vector<std::uint32_t>(247), 96, 80, asked), Error);
}

}  // namespace
}  // namespace sailmap::testing
