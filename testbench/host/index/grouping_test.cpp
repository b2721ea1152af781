// Which images share a block.
#include "index/grouping.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "index/screen.hpp"

namespace sailmap::index {
namespace {

Signature image_with_columns(const std::vector<int>& columns) {
  Signature out{640, 480, {}};
  for (const int column : columns) {
    Region region;
    region.x = static_cast<std::int16_t>(column);
    out.regions.push_back(region);
  }
  return out;
}

TEST(ColumnKeys, AreMeanColumnAndMeanDistanceFromIt) {
  EXPECT_EQ(column_keys(image_with_columns({300, 100, 400, 200})), (ColumnKeys{250, 100}));
  EXPECT_EQ(column_keys(image_with_columns({300, 100, 200})), (ColumnKeys{200, 200.0F / 3}));
  EXPECT_EQ(column_keys(image_with_columns({300})), (ColumnKeys{300, 0}));
  EXPECT_EQ(column_keys(image_with_columns({})), (ColumnKeys{0, 0}));
}

TEST(Grouping, GivesEachImageAPlaceOfItsOwnInFewBlocks) {
  std::mt19937 random(1);
  std::normal_distribution<float> anywhere(320, 80);
  Grouping grouping;
  std::set<std::pair<std::size_t, std::size_t>> places;
  constexpr std::size_t images = 50000;
  for (std::size_t i = 0; i < images; ++i) {
    const std::size_t before = grouping.blocks();
    const Grouping::Place place = grouping.add({anywhere(random), anywhere(random)});
    ASSERT_LT(place.lane, block_images);
    ASSERT_EQ(place.block == before, place.lane == 0);  // a new block begins with its first lane
    ASSERT_EQ(grouping.blocks(), before + (place.lane == 0 ? 1 : 0));
    ASSERT_TRUE(places.emplace(place.block, place.lane).second);
  }
  EXPECT_LE(static_cast<double>(grouping.blocks()), 1.1 * images / block_images);
}

TEST(Grouping, ImagesThatAreAlikeShareBlocks) {
  std::mt19937 random(2);
  constexpr float deviation = 80;
  std::normal_distribution<float> anywhere(320, deviation);
  Grouping grouping;
  std::vector<std::vector<ColumnKeys>> blocks;
  for (int i = 0; i < 50000; ++i) {
    const ColumnKeys keys{anywhere(random), anywhere(random)};
    const std::size_t block = grouping.add(keys).block;
    blocks.resize(grouping.blocks());
    blocks[block].push_back(keys);
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    double squares = 0;  // of the distances from the mean of the block
    for (const std::vector<ColumnKeys>& images : blocks) {
      double sum = 0;
      for (const ColumnKeys& keys : images) sum += keys[axis];
      const double mean = sum / static_cast<double>(images.size());
      for (const ColumnKeys& keys : images) squares += (keys[axis] - mean) * (keys[axis] - mean);
    }
    EXPECT_LT(std::sqrt(squares / 50000), 0.5 * deviation);
  }
}

TEST(Grouping, ImagesThatAreAllTheSameFillOneBlockAfterTheOther) {
  Grouping grouping;
  for (std::size_t i = 0; i < 5000; ++i) {
    const Grouping::Place place = grouping.add({320, 200});
    ASSERT_EQ(place.block, i / block_images);
    ASSERT_EQ(place.lane, i % block_images);
  }
}

}  // namespace
}  // namespace sailmap::index
