// The quantised front end: raw integers and what they are worth.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "images.hpp"
#include "sailmap/error.hpp"
#include "sailmap/frontend.hpp"
#include "sailmap/hls/arithmetic.hpp"

namespace sailmap {
namespace {

using Raw = Plane<std::uint16_t>;

Maps maps_of(const testing::RgbImage& image) {
  Maps maps;
  make_frontend("quantised")->compute(image.view(), maps);
  return maps;
}

const Raw& raw_of(const Map& map) { return std::get<Raw>(map.samples); }

TEST(QuantisedFrontEnd, NamesItsFormats) {
  const Maps maps = maps_of(testing::noise(90, 70, 1));
  EXPECT_EQ(maps.features[0].format, "intensity_feature");
  EXPECT_DOUBLE_EQ(maps.features[0].lsb, 2 / (765.0 * 21));
  EXPECT_EQ(maps.features[2].format, "colour_feature");
  EXPECT_DOUBLE_EQ(maps.features[2].lsb, 1 / (128 * 21.0));
  EXPECT_EQ(maps.features[9].format, "orientation_feature");
  EXPECT_DOUBLE_EQ(maps.features[9].lsb, 1 / (16 * 765.0));
  EXPECT_EQ(maps.conspicuities[0].format, "intensity_conspicuity");
  EXPECT_EQ(maps.saliency.format, "saliency");
  EXPECT_EQ(maps.saliency.lsb, 0x1p-14);
  EXPECT_EQ(maps.saliency.width(), 23);
  EXPECT_EQ(maps.saliency.height(), 18);
}

// From the integers of a feature map and its m, as the kernels do.
hls::Gain gain_of(const Map& map, const MapStatistics& stats) {
  const auto samples = raw_of(map).samples();
  const std::uint32_t maximum = *std::max_element(samples.begin(), samples.end());
  EXPECT_DOUBLE_EQ(stats.maximum, maximum * map.lsb);
  return hls::gain(maximum, static_cast<std::uint32_t>(stats.maxima));
}

// The conspicuities once more from the feature maps' integers, with the kernels' integer steps.
void expect_kernels_conspicuities(const Maps& maps) {
  std::array<hls::Gain, feature_count> gains{};
  for (std::size_t i = 0; i < feature_count; ++i) {
    gains.at(i) = gain_of(maps.features.at(i), maps.feature_statistics.at(i));
  }
  for (std::size_t p = 0; p < raw_of(maps.saliency).samples().size(); ++p) {
    std::array<std::uint32_t, conspicuity_count> sums{};
    for (std::size_t i = 0; i < feature_count; ++i) {
      sums.at(kind_of_feature.at(i)) += hls::normalise(raw_of(maps.features.at(i)).samples()[p], gains.at(i));
    }
    EXPECT_EQ(raw_of(maps.conspicuities[0]).samples()[p], hls::intensity_conspicuity(sums[0]));
    EXPECT_EQ(raw_of(maps.conspicuities[1]).samples()[p], hls::colour_conspicuity(sums[1]));
    EXPECT_EQ(raw_of(maps.conspicuities[2]).samples()[p], hls::orientation_conspicuity(sums[2]));
  }
}

TEST(QuantisedFrontEnd, NormalisesAsTheKernelsDo) {
  for (const auto& image : {testing::noise(131, 97, 1), testing::noise(64, 64, 2, 3),
                            testing::square(96, 12, {9, 90, 30}, {50, 50, 50})}) {
    expect_kernels_conspicuities(maps_of(image));
  }
}

TEST(QuantisedFrontEnd, RefusesSmallImages) {
  Maps maps;
  const auto image = testing::noise(63, 70, 1);
  EXPECT_THROW(make_frontend("quantised")->compute(image.view(), maps), Error);
}

TEST(QuantisedFrontEnd, LeavesNothingOfTheFrameBefore) {
  const auto frontend = make_frontend("quantised");
  Maps maps;
  frontend->compute(testing::noise(200, 150, 1).view(), maps);
  frontend->compute(testing::noise(90, 70, 2).view(), maps);
  const Maps fresh = maps_of(testing::noise(90, 70, 2));
  EXPECT_EQ(raw_of(maps.saliency), raw_of(fresh.saliency));
  for (std::size_t i = 0; i < feature_count; ++i)
    EXPECT_EQ(raw_of(maps.features[i]), raw_of(fresh.features[i]));
}

}  // namespace
}  // namespace sailmap
