// The reference's regions and descriptors against the host's own, which was written for maps of any kind.
#include "sailmap/ref/signature.hpp"

#include <gtest/gtest.h>

#include "numbers/images.hpp"
#include "sailmap/frontend.hpp"
#include "sailmap/signature.hpp"

namespace sailmap::testing {
namespace {

void expect_the_hosts(const RgbImage& image, const RegionConfig& config) {
  Maps maps;
  make_frontend("reference")->compute(image.view(), maps);
  const Signature host = make_signature(maps, config);
  const auto regions = ref::salient_regions<ref::Exact>(
      ref::compute<ref::Exact>(image.view()), {config.max_regions, config.stop_ratio, config.box_side});
  ASSERT_EQ(regions.size(), host.regions.size());
  for (std::size_t r = 0; r < regions.size(); ++r) {
    EXPECT_EQ(4 * regions[r].x, host.regions[r].x);
    EXPECT_EQ(4 * regions[r].y, host.regions[r].y);
    EXPECT_FLOAT_EQ(static_cast<float>(regions[r].saliency), host.regions[r].saliency);
    for (std::size_t i = 0; i < feature_count; ++i) {
      EXPECT_NEAR(regions[r].descriptor[i], host.regions[r].descriptor[i], 1e-6) << i;
    }
  }
}

TEST(RefSignature, IsTheHostsOnExactMaps) {
  RegionConfig config;
  expect_the_hosts(noise(173, 121, 3), config);
  expect_the_hosts(square(128, 24, {255, 120, 0}, black), config);
  config.max_regions = 9;
  config.stop_ratio = 0.5;
  config.box_side = 7;
  expect_the_hosts(noise(90, 140, 4), config);
}

// Spec section 8.
TEST(RefSignature, EntriesOfAKindSumToOneInTheExactModel) {
  const auto regions =
      ref::salient_regions<ref::Exact>(ref::compute<ref::Exact>(noise(128, 96, 5).view()), {});
  ASSERT_FALSE(regions.empty());
  for (const ref::SalientRegion& region : regions) {
    const auto& v = region.descriptor;
    EXPECT_NEAR(v[0] + v[1], 1, 1e-9);
    EXPECT_NEAR(v[2] + v[3] + v[4] + v[5], 1, 1e-9);
    EXPECT_NEAR(v[6] + v[7] + v[8] + v[9], 1, 1e-9);
  }
}

}  // namespace
}  // namespace sailmap::testing
