// Areas, cells and peaks against sums and scans written out here.
#include "context/area_means.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "context/salient_peaks.hpp"
#include "synthetic_maps.hpp"

namespace sailmap::context {
namespace {

Map counting_map(int width, int height) {
  Plane<std::uint16_t> plane(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) plane(x, y) = static_cast<std::uint16_t>(1 + x * x + 7 * y);
  }
  Map map;
  map.samples = plane;
  return map;
}

// The part of [sample, sample + 1) below `end`.
double part_below(int sample, double end) { return std::clamp(end - sample, 0.0, 1.0); }

TEST(AreaMeans, SumsCountEachSampleWithThePartCovered) {
  const Map map = counting_map(7, 5);
  const AreaMeans means(map);
  for (const double y : {0.0, 0.25, 2.0, 4.9, 5.0}) {
    for (const double x : {0.0, 0.5, 3.0, 6.75, 7.0}) {
      double expected = 0;
      for (int j = 0; j < 5; ++j) {
        for (int i = 0; i < 7; ++i) expected += part_below(i, x) * part_below(j, y) * map.at(i, j);
      }
      EXPECT_NEAR(means.sum(x, y), expected, 1e-9) << x << ", " << y;
    }
  }
}

TEST(CellEdges, CellsOutsideTakeTheNearestInside) {
  const CellEdges edges(-5, 2, 8, 7);  // -5 -3 -1 1 3 5 7 7 7: two cells before the image, one after
  EXPECT_EQ(edges.source, (std::vector<int>{2, 2, 2, 3, 4, 5, 5, 5}));
  EXPECT_EQ(edges.at.front(), 0);
  EXPECT_EQ(edges.at.back(), 7);
}

TEST(RootMeans, AreRootsOfMeansOfCells) {
  const AreaMeans means(counting_map(4, 4));
  std::vector<float> cells;
  root_means(means, CellEdges(0, 2, 2, 4), CellEdges(0, 2, 2, 4), cells);
  // Samples of the cell at the top right: 5, 10 above, 12, 17 below.
  EXPECT_FLOAT_EQ(cells[1], std::sqrt(11.0F));
}

TEST(SalientPeaks, AreThoseOfARepeatedScanOfTheWholeMap) {
  const Map saliency = testing::scene_maps(3).saliency;
  Plane<double> left = saliency.values();
  const auto peaks = salient_peaks(saliency, 60);
  ASSERT_GT(peaks.size(), 20U);
  for (const Peak& peak : peaks) {
    const auto samples = left.samples();
    const auto highest = static_cast<int>(std::max_element(samples.begin(), samples.end()) - samples.begin());
    ASSERT_EQ(peak.y * 160 + peak.x, highest);
    for (int y = std::max(0, peak.y - 4); y <= std::min(119, peak.y + 4); ++y) {
      for (int x = std::max(0, peak.x - 4); x <= std::min(159, peak.x + 4); ++x) left(x, y) = 0;
    }
  }
}

}  // namespace
}  // namespace sailmap::context
