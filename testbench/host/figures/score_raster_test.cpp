// The score matrix made small: against brute force over all scores.
#include "figures/score_raster.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sailmap/error.hpp"
#include "sailmap/evaluation.hpp"

namespace sailmap {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

GroundTruth nothing(int queries) {
  GroundTruth truth;
  truth.matches.resize(static_cast<std::size_t>(queries));
  return truth;
}

struct Random {
  Plane<float> scores;
  GroundTruth truth;
};

// A third of the scores, and all of some blocks, are missing.
Random random_scores(int width, int height, unsigned seed) {
  Random out{Plane<float>(width, height), nothing(height)};
  std::mt19937 random(seed);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool missing = random() % 3 == 0 || x > y + width / 2;
      out.scores(x, y) = missing ? not_admissible : static_cast<float>(random() % 100000) / 7;
      if (random() % 50 == 0) out.truth.matches[static_cast<std::size_t>(y)].push_back(x);
    }
  }
  return out;
}

TEST(ScoreRaster, EachCellIsTheHighestOfItsBlock) {
  for (const auto& [w, h, most] :
       {std::tuple{250, 100, 100}, {97, 311, 40}, {50, 40, 100}, {101, 100, 100}, {7, 1, 3}}) {
    SCOPED_TRACE(std::to_string(w) + "x" + std::to_string(h));
    const Random in = random_scores(w, h, 5);
    const ScoreRaster raster = rasterise(in.scores, in.truth, most);
    const int cw = raster.cells.width();
    const int ch = raster.cells.height();
    ASSERT_EQ(cw, std::min(w, most));
    ASSERT_EQ(ch, std::min(h, most));
    for (int cy = 0; cy < ch; ++cy) {
      for (int cx = 0; cx < cw; ++cx) {
        float highest = -1;
        bool matched = false;
        for (int y = cy * h / ch; y < (cy + 1) * h / ch; ++y) {
          const auto& matches = in.truth.matches[static_cast<std::size_t>(y)];
          for (int x = cx * w / cw; x < (cx + 1) * w / cw; ++x) {
            if (std::isnan(in.scores(x, y))) continue;
            highest = std::max(highest, in.scores(x, y));
            matched = matched || std::count(matches.begin(), matches.end(), x) > 0;
          }
        }
        if (highest < 0) {
          EXPECT_TRUE(std::isnan(raster.cells(cx, cy)));
        } else {
          EXPECT_EQ(raster.cells(cx, cy), highest);
        }
        EXPECT_EQ(raster.is_match(cx, cy) != 0, matched);
      }
    }
  }
}

TEST(ScoreRaster, TheCeilingIsThe995thOfAThousandCells) {
  Plane<float> scores(1000, 1, 0);
  for (int x = 0; x < 1000; ++x) scores((x * 387) % 1000, 0) = static_cast<float>(x);
  EXPECT_EQ(rasterise(scores, nothing(1), 1000).ceiling, 994);
  scores(17, 0) = 1e6F;  // one pair of identical images does not matter
  EXPECT_LE(rasterise(scores, nothing(1), 1000).ceiling, 995);
}

TEST(ScoreRaster, TheCeilingIsNeverZero) {
  EXPECT_EQ(rasterise(Plane<float>(20, 20, 0), nothing(20), 100).ceiling, 1);
  EXPECT_EQ(rasterise(Plane<float>(20, 20, not_admissible), nothing(20), 100).ceiling, 1);
  Plane<float> lonely(100, 100, 0);
  lonely(50, 50) = 3;
  EXPECT_EQ(rasterise(lonely, nothing(100), 100).ceiling, 3);
}

TEST(ScoreRaster, RefusesGroundTruthOfSomethingElse) {
  GroundTruth far = nothing(4);
  far.matches[2] = {5};
  const auto rasterised = [](const Plane<float>& scores, const GroundTruth& truth) {
    return [=] { rasterise(scores, truth, 10); };
  };
  EXPECT_THAT(rasterised({}, {}), ThrowsMessage<Error>(HasSubstr("no scores")));
  EXPECT_THAT(rasterised(Plane<float>(5, 4), nothing(3)), ThrowsMessage<Error>(HasSubstr("3 queries")));
  EXPECT_THAT(rasterised(Plane<float>(5, 4), far),
              ThrowsMessage<Error>(HasSubstr("query 2 matches candidate 5")));
  far.matches[2] = {-1};
  EXPECT_THAT(rasterised(Plane<float>(5, 4), far), ThrowsMessage<Error>(HasSubstr("candidate -1")));
}

TEST(Enlarged, RepeatsCellsOrLeavesThem) {
  Plane<float> cells(3, 2);
  for (int i = 0; i < 6; ++i) cells(i % 3, i / 3) = static_cast<float>(i);
  const Plane<float> large = enlarged(cells, 10);
  ASSERT_EQ(large.width(), 12);
  ASSERT_EQ(large.height(), 8);
  EXPECT_EQ(large(0, 0), 0);
  EXPECT_EQ(large(3, 3), 0);
  EXPECT_EQ(large(4, 3), 1);
  EXPECT_EQ(large(11, 7), 5);
  EXPECT_EQ(enlarged(cells, 3), cells);
  EXPECT_EQ(enlarged(cells, 1), cells);
}

Plane<char> random_mask(int width, int height, unsigned one_in, unsigned seed) {
  Plane<char> mask(width, height, 0);
  std::mt19937 random(seed);
  for (char& cell : mask.samples()) cell = random() % one_in == 0 ? 1 : 0;
  return mask;
}

TEST(Outline, HasEveryEdgeBetweenUnlikeCellsOnce) {
  const Plane<char> mask = random_mask(23, 17, 3, 8);
  // How often each unit edge is drawn: above (x, y) and left of (x, y).
  Plane<int> above(24, 18, 0);
  Plane<int> left(24, 18, 0);
  for (const Segment& s : outline(mask, 100000)) {
    ASSERT_TRUE(s.x0 == s.x1 || s.y0 == s.y1);
    if (s.y0 == s.y1) {
      for (int x = static_cast<int>(s.x0); x < static_cast<int>(s.x1); ++x)
        ++above(x, static_cast<int>(s.y0));
    } else {
      for (int y = static_cast<int>(s.y0); y < static_cast<int>(s.y1); ++y) ++left(static_cast<int>(s.x0), y);
    }
  }
  const auto is_set = [&mask](int x, int y) {
    return x >= 0 && y >= 0 && x < mask.width() && y < mask.height() && mask(x, y) != 0;
  };
  for (int y = 0; y <= mask.height(); ++y) {
    for (int x = 0; x <= mask.width(); ++x) {
      EXPECT_EQ(above(x, y), is_set(x, y) != is_set(x, y - 1) ? 1 : 0) << x << ' ' << y;
      EXPECT_EQ(left(x, y), is_set(x, y) != is_set(x - 1, y) ? 1 : 0) << x << ' ' << y;
    }
  }
}

TEST(Outline, StraightEdgesAreOneSegment) {
  Plane<char> mask(10, 6, 0);
  for (int x = 2; x < 9; ++x) mask(x, 3) = 1;
  EXPECT_THAT(outline(mask, 100), ::testing::UnorderedElementsAre(Segment{2, 3, 9, 3}, Segment{2, 4, 9, 4},
                                                                  Segment{2, 3, 2, 4}, Segment{9, 3, 9, 4}));
  EXPECT_TRUE(outline(Plane<char>(10, 6, 0), 100).empty());
}

// A point is inside when a ray to the left crosses the outline an odd number of times.
bool inside(const std::vector<Segment>& outline, double x, double y) {
  int crossed = 0;
  for (const Segment& s : outline) {
    if (s.x0 == s.x1 && s.x0 < x && std::min(s.y0, s.y1) < y && std::max(s.y0, s.y1) > y) ++crossed;
  }
  return crossed % 2 == 1;
}

TEST(Outline, OfTooMuchDetailIsCoarserButStillHoldsEveryMatch) {
  const Plane<char> mask = random_mask(101, 67, 20, 3);
  const auto fine = outline(mask, 1U << 20U);
  for (const std::size_t most : {200U, 50U, 4U}) {
    const auto coarse = outline(mask, most);
    ASSERT_GT(fine.size(), most);
    EXPECT_LE(coarse.size(), most);
    EXPECT_FALSE(coarse.empty());
    for (int y = 0; y < mask.height(); ++y) {
      for (int x = 0; x < mask.width(); ++x) {
        if (mask(x, y) == 0) continue;
        ASSERT_TRUE(inside(fine, x + 0.5, y + 0.5));
        ASSERT_TRUE(inside(coarse, x + 0.5, y + 0.5)) << most << ": " << x << ' ' << y;
      }
    }
    for (const Segment& s : coarse) {
      EXPECT_LE(std::max(s.x0, s.x1), 101);
      EXPECT_LE(std::max(s.y0, s.y1), 67);
    }
  }
}

TEST(Widened, GrowsByAsManyCellsOnEachSide) {
  const Plane<char> mask = random_mask(31, 19, 60, 4);
  for (const int by : {0, 1, 3}) {
    const Plane<char> wide = widened(mask, by);
    for (int y = 0; y < mask.height(); ++y) {
      for (int x = 0; x < mask.width(); ++x) {
        char near = 0;
        for (int dy = -by; dy <= by; ++dy) {
          for (int dx = -by; dx <= by; ++dx) {
            if (x + dx < 0 || y + dy < 0 || x + dx >= mask.width() || y + dy >= mask.height()) continue;
            near = std::max(near, mask(x + dx, y + dy));
          }
        }
        EXPECT_EQ(wide(x, y), near) << by << ": " << x << ' ' << y;
      }
    }
  }
}

}  // namespace
}  // namespace sailmap
