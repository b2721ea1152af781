// Spec section 8 as it is written, every sample looked at for every peak and every mean, against the
// library's way.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sailmap/signature.hpp"

namespace sailmap {
namespace {

// What inhibition leaves of a sample (dx, dy) from the peak.
double remaining(int dx, int dy, const RegionConfig& config) {
  const double d2 = static_cast<double>(dx) * dx + static_cast<double>(dy) * dy;
  const double r2 = config.inhibition_radius * config.inhibition_radius;
  const int before = config.box_side / 2;
  switch (config.inhibition) {
    case Inhibition::box: {
      const auto inside = [&](int d) { return d >= -before && d < config.box_side - before; };
      return inside(dx) && inside(dy) ? 0 : 1;
    }
    case Inhibition::disk:
      return d2 <= r2 ? 0 : 1;
    case Inhibition::gaussian:
      return -std::expm1(-d2 / (2 * r2));
  }
  return 1;
}

std::vector<Peak> peaks_as_written(Plane<double> map, const RegionConfig& config) {
  std::vector<Peak> peaks;
  while (static_cast<int>(peaks.size()) < config.max_regions) {
    Peak best{0, 0, 0};
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        if (map(x, y) > best.saliency) best = {x, y, map(x, y)};
      }
    }
    if (best.saliency <= 0) break;
    if (!peaks.empty() && best.saliency <= peaks.front().saliency * config.stop_ratio) break;
    peaks.push_back(best);
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) map(x, y) *= remaining(x - best.x, y - best.y, config);
    }
  }
  return peaks;
}

// Few levels, so that many samples are equal; the worth of one is no power of two.
Map random_map(std::mt19937& random, int width, int height, unsigned levels) {
  Map map;
  map.lsb = 1 / 765.0;
  Plane<std::uint16_t> samples(width, height);
  for (auto& v : samples.samples()) v = static_cast<std::uint16_t>(random() % levels);
  map.samples = samples;
  return map;
}

void expect_as_written(const Map& map, const RegionConfig& config) {
  const std::vector<Peak> got = find_peaks(map, config);
  const std::vector<Peak> want = peaks_as_written(map.values(), config);
  ASSERT_EQ(got.size(), want.size());
  for (std::size_t i = 0; i < want.size(); ++i) {
    EXPECT_EQ(got[i].x, want[i].x) << i;
    EXPECT_EQ(got[i].y, want[i].y) << i;
    EXPECT_EQ(got[i].saliency, want[i].saliency) << i;
  }
}

TEST(RegionsExhaustively, AsWrittenForAllInhibitionsAndTypesOfMaps) {
  std::mt19937 random(3);
  for (const unsigned levels : {2U, 7U, 300U, 65536U}) {
    for (const auto& [width, height] : {std::pair{16, 16}, {41, 23}, {17, 90}}) {
      const Map raw = random_map(random, width, height, levels);
      Map real;
      real.samples = raw.values();
      for (const Inhibition inhibition : {Inhibition::box, Inhibition::disk, Inhibition::gaussian}) {
        RegionConfig config;
        config.inhibition = inhibition;
        config.box_side = 4 + static_cast<int>(random() % 8);
        config.inhibition_radius = 1.5 + static_cast<double>(random() % 5);
        SCOPED_TRACE(std::to_string(width) + " wide, " + std::to_string(levels) + " levels");
        expect_as_written(raw, config);
        expect_as_written(real, config);
      }
    }
  }
}

TEST(RegionsExhaustively, MeansOfRawMapsAreThoseOfTheirValues) {
  std::mt19937 random(4);
  const Map raw = random_map(random, 40, 30, 65536);
  for (int i = 0; i < 100; ++i) {
    const int x0 = static_cast<int>(random() % 40);
    const int y0 = static_cast<int>(random() % 30);
    const Box box{x0, y0, x0 + 1 + static_cast<int>(random() % static_cast<unsigned>(40 - x0)),
                  y0 + 1 + static_cast<int>(random() % static_cast<unsigned>(30 - y0))};
    double sum = 0;
    for (int y = box.y0; y < box.y1; ++y) {
      for (int x = box.x0; x < box.x1; ++x) sum += std::get<Plane<std::uint16_t>>(raw.samples)(x, y);
    }
    EXPECT_EQ(raw.mean(box), raw.lsb * sum / box.area());
  }
}

}  // namespace
}  // namespace sailmap
