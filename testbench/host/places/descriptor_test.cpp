// Spec section 8, eq. 3-6: descriptors and signatures.
#include <gmock/gmock.h>

#include <numeric>

#include "sailmap/frontend.hpp"
#include "sailmap/signature.hpp"

namespace sailmap {
namespace {

// Maps of 20 x 20 whose feature i is constant i + 1, and twice that in the left half.
Maps stepped_maps() {
  Maps maps;
  maps.image_width = 80;
  maps.image_height = 80;
  std::array<Plane<double>, conspicuity_count> sums;
  sums.fill(Plane<double>(20, 20));
  for (std::size_t i = 0; i < feature_count; ++i) {
    Plane<double> plane(20, 20);
    maps.feature_statistics[i] = {2.0 * static_cast<double>(i + 1), 4};
    for (int y = 0; y < 20; ++y) {
      for (int x = 0; x < 20; ++x) {
        plane(x, y) = static_cast<double>(i + 1) * (x < 10 ? 2 : 1);
        sums[kind_of_feature[i]](x, y) += plane(x, y) / (2.0 * static_cast<double>(i + 1) * 2);
      }
    }
    maps.features[i].samples = plane;
  }
  for (std::size_t k = 0; k < conspicuity_count; ++k) maps.conspicuities[k].samples = sums[k];
  maps.saliency.samples = Plane<double>(20, 20);
  return maps;
}

TEST(Descriptor, SharesOfEachKindByHand) {
  // Every X~ is 1/2 on the left and 1/4 on the right, so each entry is one over the number of maps of its
  // kind.
  const Descriptor v = describe(stepped_maps(), {2, 2, 18, 7}, DescriptorKind::conspicuity);
  for (std::size_t i = 0; i < feature_count; ++i)
    EXPECT_NEAR(v[i], kind_of_feature[i] == 0 ? 0.5 : 0.25, 1e-7) << i;
}

TEST(Descriptor, AgainstTheBackgroundByHand) {
  // Box in the left half: mean 2(i+1) inside; outside (400*1.5 - 50*2)/350 times (i+1).
  const Descriptor v = describe(stepped_maps(), {0, 0, 10, 5}, DescriptorKind::background);
  for (const float entry : v) EXPECT_FLOAT_EQ(entry, 2.0F / (500.0F / 350.0F));
}

TEST(Descriptor, ZeroWhereTheKindIsZero) {
  Maps maps = stepped_maps();
  for (std::size_t i = 0; i < 2; ++i) {
    maps.features[i].samples = Plane<double>(20, 20);
    maps.feature_statistics[i] = {};
  }
  maps.conspicuities[0].samples = Plane<double>(20, 20);
  for (const DescriptorKind kind : {DescriptorKind::conspicuity, DescriptorKind::background}) {
    const Descriptor v = describe(maps, {0, 0, 10, 10}, kind);
    EXPECT_EQ(v[0], 0);
    EXPECT_EQ(v[1], 0);
    EXPECT_GT(v[2], 0);
  }
}

TEST(Signature, OfARealFrontEndSumsToOneWithinEachKind) {
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(131) * 97 * 3);
  std::uint32_t state = 1;
  for (auto& p : pixels) {
    state = state * 1664525U + 1013904223U;
    p = static_cast<std::uint8_t>(state >> 24U);
  }
  Maps maps;
  make_frontend("reference")->compute({131, 97, pixels.data(), 131 * 3, ChannelOrder::bgr}, maps);
  const Signature signature = make_signature(maps, {});
  EXPECT_EQ(signature.width, 131);
  EXPECT_EQ(signature.height, 97);
  ASSERT_FALSE(signature.regions.empty());
  double last = signature.regions.front().saliency;
  for (const Region& region : signature.regions) {
    EXPECT_LE(region.saliency, last);
    last = region.saliency;
    EXPECT_EQ(region.x % 4, 0);
    EXPECT_EQ(region.saliency, static_cast<float>(maps.saliency.at(region.x / 4, region.y / 4)));
    const auto& v = region.descriptor;
    // Each entry is rounded to single precision.
    EXPECT_NEAR(v[0] + v[1], 1, 1e-6);
    EXPECT_NEAR(v[2] + v[3] + v[4] + v[5], 1, 1e-6);
    EXPECT_NEAR(std::accumulate(v.begin() + 6, v.end(), 0.0), 1, 1e-6);
  }
}

}  // namespace
}  // namespace sailmap
