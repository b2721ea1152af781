// The parts of the index: vectorised kernels against plain ones in every instruction set at hand, bounds
// against what they bound.
#include "index/kernels.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>

#include "host/index/each_target.hpp"
#include "host/index/random_maps.hpp"
#include "index/estimate.hpp"
#include "index/leaders.hpp"
#include "index/plain_kernels.hpp"
#include "index/region_code.hpp"
#include "index/screen.hpp"
#include "simulated_signatures.hpp"

namespace sailmap::index {
namespace {

using sailmap::testing::for_each_target;
using sailmap::testing::RandomMaps;

std::vector<Signature> bounded_images(std::uint64_t seed, int count) {
  RandomMaps random(seed);
  std::vector<Signature> out;
  for (const auto& views : random.map(count, false).nodes) {
    if (can_be_bounded(views.front())) out.push_back(views.front());
  }
  return out;
}

TEST(IndexKernels, AllInstructionSetsScreenAlike) {
  for_each_target([] {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      SCOPED_TRACE(seed);
      RandomMaps random(seed);
      const std::vector<Signature> images = bounded_images(seed, static_cast<int>(block_images));
      Block block;
      for (std::size_t lane = 0; lane < images.size(); ++lane) block.add(lane, images[lane]);
      const Signature& query =
          images[static_cast<std::size_t>(random.below(static_cast<int>(images.size())))];
      if (query.regions.empty()) continue;
      ScreenQuery screen(query, random.config());
      for (const double threshold : {0.3, 1.0, 3.0, 20.0}) {
        screen.set_threshold(threshold);
        ASSERT_EQ(screen.passing(block), plain::screen(block, screen));
      }
    }
  });
}

TEST(IndexKernels, ScreeningNeverLosesAnImage) {
  int lost = 0;
  int spared = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    RandomMaps random(seed);
    const std::vector<Signature> images = bounded_images(seed, static_cast<int>(block_images));
    Block block;
    for (std::size_t lane = 0; lane < images.size(); ++lane) block.add(lane, images[lane]);
    const MatchConfig config = random.config();
    if (images.front().regions.empty()) continue;
    ScreenQuery screen(images.front(), config);
    for (const double threshold : {0.2, 0.5, 0.8, 1.0, 1.3, 1.6, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0}) {
      screen.set_threshold(threshold);
      const std::uint64_t passing = screen.passing(block);
      for (std::size_t lane = 0; lane < images.size(); ++lane) {
        const bool passes = ((passing >> lane) & 1U) != 0;
        const bool reaches = match(images.front(), images[lane], config).similarity >= threshold;
        lost += reaches && !passes ? 1 : 0;
        spared += passes ? 0 : 1;
      }
    }
  }
  EXPECT_EQ(lost, 0);
  EXPECT_GT(spared, 10000);  // or screening would be for nothing
}

Signature image_with_region(int width, int height, double x, double y) {
  Region region;
  region.x = static_cast<std::int16_t>(std::clamp(x, 0.0, width - 1.0));
  region.y = static_cast<std::int16_t>(std::clamp(y, 0.0, height - 1.0));
  return {width, height, {region}};
}

TEST(IndexKernels, ScreeningFindsAdmissiblePositionsInImagesOfAnySize) {
  // Corners and borders of images of all sizes, where sixteen bits are nearly too few, and any place between.
  constexpr std::array<std::array<int, 2>, 7> sizes = {
      {{640, 480}, {960, 540}, {1016, 1016}, {1920, 1080}, {64, 4000}, {7, 5}, {32767, 32767}}};
  for_each_target([&] {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(-0.3, 1.3);
    for (const auto& [width, height] : sizes) {
      SCOPED_TRACE(width);
      for (int i = 0; i < 300; ++i) {
        const Signature query =
            image_with_region(width, height, anywhere(random) * width, anywhere(random) * height);
        const Region& from = query.regions.front();
        MatchConfig config;
        if (i % 4 == 0) config.search_radius = 2;
        const double reach = std::min(1.0, config.search_radius) * std::hypot(width, height);
        Block block;
        std::vector<Signature> images;
        for (std::size_t lane = 0; lane < block_images; ++lane) {
          images.push_back(image_with_region(width, height, from.x + reach * (2 * anywhere(random) - 1),
                                             from.y + reach * (2 * anywhere(random) - 1)));
          block.add(lane, images.back());
        }
        ScreenQuery screen(query, config);
        screen.set_threshold(1);
        const std::uint64_t passing = screen.passing(block);
        ASSERT_EQ(passing, plain::screen(block, screen));
        for (std::size_t lane = 0; lane < block_images; ++lane) {
          const bool matches = match(query, images[lane], config).similarity > 0;
          ASSERT_TRUE(!matches || ((passing >> lane) & 1U) != 0) << from.x << ' ' << from.y;
        }
      }
    }
  });
}

// At one place, with these projections in code steps.
Signature image_of_projection(const Projection& steps) {
  const std::array<double, directions> p = [&] {
    std::array<double, directions> out{};
    std::transform(steps.begin(), steps.end(), out.begin(), [](double number) { return number * step; });
    return out;
  }();
  const std::array<double, feature_count> v = {p[0] * std::sqrt(0.5),     -p[0] * std::sqrt(0.5),
                                               (p[1] + p[2] + p[3]) / 2,  (p[1] - p[2] - p[3]) / 2,
                                               (-p[1] + p[2] - p[3]) / 2, (-p[1] - p[2] + p[3]) / 2,
                                               (p[4] + p[5] + p[6]) / 2,  (p[4] - p[5] - p[6]) / 2,
                                               (-p[4] - p[5] + p[6]) / 2, (-p[4] + p[5] - p[6]) / 2};
  Signature out = image_with_region(640, 480, 320, 240);
  std::transform(v.begin(), v.end(), out.regions.front().descriptor.begin(),
                 [](double number) { return static_cast<float>(number); });
  return out;
}

bool passes_at_its_similarity(const Signature& query, const Signature& image, Method method) {
  MatchConfig config;
  config.method = method;
  Block block;
  block.add(0, image);
  ScreenQuery screen(query, config);
  screen.set_threshold(match(query, image, config).similarity);
  return (screen.passing(block) & 1U) != 0;
}

TEST(IndexKernels, ScreeningNeverLosesASingleRegion) {
  for_each_target([] {
    std::mt19937 random(13);
    std::uniform_real_distribution<double> anywhere(-40, 40);
    for (int i = 0; i < 2000; ++i) {
      Projection a;
      Projection b;
      const double apart = i % 3 == 0 ? 1 : 0.02;
      for (std::size_t k = 0; k < directions; ++k) {
        a[k] = anywhere(random);
        b[k] = a[k] + apart * anywhere(random);
      }
      const Method method = i % 2 == 0 ? Method::paper : Method::paper_weighted;
      ASSERT_TRUE(passes_at_its_similarity(image_of_projection(a), image_of_projection(b), method)) << i;
    }
  });
}

TEST(IndexKernels, ScreeningNeverLosesADistanceThatIsTheNumberForNone) {
  // From code to code 65535 squared steps: 4 * 127^2 + 31^2 + 7^2 + 3^2.
  const Signature query = image_of_projection({63, 63, 63, 63, 0, 0, 0});
  const Signature image = image_of_projection({-64, -64, -64, -64, 31, 7, 3});
  EXPECT_TRUE(passes_at_its_similarity(query, image, Method::paper));
  EXPECT_TRUE(passes_at_its_similarity(query, image, Method::paper_weighted));
}

TEST(IndexKernels, AllInstructionSetsEstimateTheSimilarity) {
  for_each_target([] {
    int estimated = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      SCOPED_TRACE(seed);
      RandomMaps random(seed);
      const std::vector<Signature> images = bounded_images(seed, 50);
      const MatchConfig config = random.config();
      Estimator estimate(images.front(), config);
      for (const Signature& image : images) {
        const double exact = match(images.front(), image, config).similarity;
        const double found = estimate(image);
        ASSERT_GE(found, exact);
        if (!std::isfinite(found)) continue;
        ++estimated;
        ASSERT_LE(found, exact * 1.0002);
      }
    }
    EXPECT_GT(estimated, 1000);
  });
}

TEST(IndexKernels, TheSortingNetworkSorts) {
  // A network that sorts all sequences of zeros and ones sorts all sequences.
  for (std::size_t size = 0; size <= 14; ++size) {
    const SortingNetwork network = sorting_network(size);
    for (std::uint32_t sequence = 0; sequence < (1U << size); ++sequence) {
      std::uint32_t bits = sequence;
      for (const auto& [i, j] : network) {
        const std::uint32_t both = (bits >> i) & (bits >> j) & 1U;
        const std::uint32_t either = ((bits >> i) | (bits >> j)) & 1U;
        bits = (bits & ~(1U << i) & ~(1U << j)) | (both << i) | (either << j);
      }
      ASSERT_EQ(bits & (bits + (bits & (~bits + 1U))) & ((1U << size) - 1U), 0U) << size << ' ' << sequence;
      for (std::size_t i = 1; i < size; ++i) ASSERT_LE((bits >> (i - 1)) & 1U, (bits >> i) & 1U);
    }
  }
}

TEST(RegionCode, StandsForWhatItsErrorSays) {
  sailmap::testing::SimulatedWay way(5);
  double largest = 0;
  for (int i = 0; i < 200; ++i) {
    const Signature image = way.next();
    const PositionGrid grid(image.width, image.height);
    for (const Region& region : image.regions) {
      const RegionCode code = encode(region, grid);
      const Projection p = project(region.descriptor);
      double squared = 0;
      for (std::size_t k = 0; k < directions; ++k) {
        const double error = p[k] - step * code[k];
        squared += error * error;
      }
      largest = std::max(largest, std::sqrt(squared));
      EXPECT_NEAR(code_error(region.descriptor, code), std::sqrt(squared), 1e-9);
      EXPECT_TRUE(is_exact(region, grid));
      EXPECT_EQ(4 * (position_zero + code[column_byte]), region.x);
      EXPECT_EQ(4 * (position_zero + code[row_byte]), region.y);
    }
  }
  EXPECT_LE(largest, largest_code_error);
  EXPECT_GT(largest, 0.7 * largest_code_error);
}

TEST(RegionCode, PositionsAreExactInImagesOfAThousandColumns) {
  const PositionGrid grid(960, 540);
  EXPECT_EQ(grid.step, 4);
  for (std::int16_t x = 0; x < 960; x += 4) {
    Region region;
    region.x = x;
    region.y = static_cast<std::int16_t>(x * 9 / 64 * 4);
    EXPECT_TRUE(is_exact(region, grid)) << x;
  }
  EXPECT_GT(PositionGrid(1920, 1080).step, 4);
}

TEST(RegionCode, CodesOfTheQueryStandForWhatTheirErrorsSay) {
  sailmap::testing::SimulatedWay way(6);
  double largest = 0;
  for (int i = 0; i < 200; ++i) {
    for (const Region& region : way.next().regions) {
      const QueryCode code = encode_query(region.descriptor);
      const Projection p = project(region.descriptor);
      double squared = 0;
      for (std::size_t k = 0; k < directions; ++k) {
        const double error = p[k] - step / 2 * code[k];
        squared += error * error;
      }
      EXPECT_NEAR(code_error(region.descriptor, code), std::sqrt(squared), 1e-9);
      largest = std::max(largest, std::sqrt(squared));
    }
  }
  EXPECT_LE(largest, largest_code_error / 2 + 1e-9);  // unless at the very end of the codes
}

TEST(RegionCode, ProjectionsAreNoFurtherApartThanDescriptors) {
  std::mt19937 random(7);
  std::normal_distribution<float> normal(0, 600);
  for (int i = 0; i < 2000; ++i) {
    Descriptor a, b;
    for (std::size_t k = 0; k < feature_count; ++k) {
      a[k] = normal(random);
      b[k] = normal(random);
    }
    const Projection p = project(a);
    const Projection q = project(b);
    double projected = 0;
    double full = 0;
    for (std::size_t k = 0; k < directions; ++k) projected += (p[k] - q[k]) * (p[k] - q[k]);
    for (std::size_t k = 0; k < feature_count; ++k) full += std::pow(static_cast<double>(a[k]) - b[k], 2);
    ASSERT_LE(projected, full * (1 + 1e-12));
  }
}

TEST(Leaders, TheThresholdIsNeverAboveTheRunnerUp) {
  std::mt19937 random(11);
  for (int run = 0; run < 300; ++run) {
    const int nodes = std::uniform_int_distribution<int>(1, 60)(random);
    const int same_place = std::uniform_int_distribution<int>(-1, 12)(random);
    std::vector<Candidate> candidates;
    for (int node = 0; node < nodes; ++node) {
      candidates.push_back({node, static_cast<double>(std::uniform_int_distribution<int>(0, 9)(random))});
    }
    const double at_least = std::uniform_int_distribution<int>(0, 10)(random);
    std::vector<Candidate> counting = candidates;
    std::erase_if(counting, [&](const Candidate& c) { return c.similarity < at_least; });
    const Ranking expected = rank(counting, same_place);
    Leaders leaders(same_place, at_least);
    std::shuffle(candidates.begin(), candidates.end(), random);
    for (const Candidate& candidate : candidates) {
      leaders.add(candidate);
      ASSERT_LE(leaders.threshold(), std::max(at_least, expected.runner_up.similarity));
    }
    ASSERT_EQ(leaders.ranking(nodes), expected);
  }
}

}  // namespace
}  // namespace sailmap::index
