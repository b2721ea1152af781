// Bits of the descriptor against maps whose bits can be told by hand; text there and back.
#include "sailmap/place_descriptor.hpp"

#include <gtest/gtest.h>

#include <bit>

#include "sailmap/error.hpp"
#include "synthetic_maps.hpp"

namespace sailmap {
namespace {

using testing::scene_maps;

Maps flat_maps() {
  Maps maps = scene_maps(1);
  for (Map& map : maps.features) map.samples = Plane<double>(160, 120, 0.0);
  maps.saliency.samples = Plane<double>(160, 120, 0.0);
  return maps;
}

TEST(PlaceDescriptor, AFlatImageHasNoRegionAndNoBit) {
  EXPECT_EQ(describe_place(flat_maps()), PlaceDescriptor{});
}

TEST(PlaceDescriptor, BitsStandWhereAMapIsAboveItsMean) {
  Maps maps = flat_maps();
  Plane<double> bar(160, 120, 0.0);
  for (int y = 0; y < 120; ++y) {
    for (int x = 80; x < 90; ++x) bar(x, y) = 5;  // the ninth of the layout's columns
  }
  maps.features[4].samples = bar;
  Plane<double> peak(160, 120, 0.0);
  peak(85, 60) = 1;
  maps.saliency.samples = peak;
  const PlaceDescriptor place = describe_place(maps);

  Layout layout;
  for (std::size_t row = 0; row < 12; ++row) {
    const std::size_t bit = 10 * row + 4;
    layout.words[8][bit / 64] |= std::uint64_t{1} << (bit % 64);
  }
  EXPECT_EQ(place.layout, layout);

  // The context is 50 x 50 samples about (85.5, 60.5): columns of 6.25 from 60.5 on; the bar covers part of
  // the fourth (79.25 .. 85.5) and fifth (85.5 .. 91.75).
  ASSERT_EQ(place.regions.size(), 1U);
  const ContextRegion& region = place.regions.front();
  EXPECT_EQ(region.varied, 1U << 4);
  for (std::size_t map = 0; map < feature_count; ++map) {
    EXPECT_EQ(region.bits[map], map == 4 ? 0x1818181818181818U : 0U);
  }
  EXPECT_NEAR(region.x / 65535.0, 85.5 / 160, 1e-5);
  EXPECT_NEAR(region.y / 65535.0, 60.5 / 120, 1e-5);
}

TEST(PlaceDescriptor, TheUnitOfAMapDoesNotCount) {
  Maps maps = scene_maps(5);
  const PlaceDescriptor before = describe_place(maps);
  for (Map& map : maps.features) {
    for (double& sample : std::get<Plane<double>>(map.samples).samples()) sample *= 64;
  }
  EXPECT_EQ(describe_place(maps), before);
}

TEST(PlaceDescriptor, IsSmall) {
  const PlaceDescriptor place = describe_place(scene_maps(7));
  EXPECT_LE(place.regions.size(), 85U);
  EXPECT_LE(sizeof(PlaceDescriptor) + 85 * sizeof(ContextRegion), 8192U);
}

TEST(PlaceDescriptor, IsTheSameAfterTextAndBack) {
  const PlaceDescriptor place = describe_place(scene_maps(9));
  EXPECT_EQ(place_from_text(to_text(place)), place);
}

TEST(PlaceDescriptor, DamagedTextIsRefused) {
  std::string text = to_text(describe_place(scene_maps(9)));
  EXPECT_THROW(place_from_text(text.substr(1)), Error);
  EXPECT_THROW(place_from_text(""), Error);
  text[20] = 'x';
  EXPECT_THROW(place_from_text(text), Error);
  EXPECT_THROW(place_from_text(std::string(16 * (32 + 86 * 11), '0')), Error);  // a region too many
}

}  // namespace
}  // namespace sailmap
