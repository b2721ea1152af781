// The index against the exhaustive answer: equal bit for bit.
#include "sailmap/place_index.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <limits>

#include "host/index/exhaustive.hpp"
#include "host/index/random_maps.hpp"
#include "host/map_builders.hpp"
#include "sailmap/error.hpp"
#include "simulated_signatures.hpp"

namespace sailmap {
namespace {

using testing::exhaustive;
using testing::indexed;
using testing::RandomMaps;
using testing::Views;

// SAILMAP_SEED gives another beginning of the random runs than 1.
std::uint64_t first_seed() {
  const char* seed = std::getenv("SAILMAP_SEED");
  return seed == nullptr ? 1 : std::strtoull(seed, nullptr, 10);
}

PlaceIndex index_of(const std::vector<Views>& nodes) {
  PlaceIndex index;
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    for (std::size_t view = 0; view < nodes[node].size(); ++view) {
      index.add({static_cast<int>(node), static_cast<int>(view)}, nodes[node][view]);
    }
  }
  return index;
}

std::vector<Views> nodes_of(const std::vector<Signature>& signatures) {
  std::vector<Views> nodes;
  for (const Signature& signature : signatures) nodes.push_back({signature});
  return nodes;
}

void expect_same(const Ranking& found, const Ranking& expected) {
  EXPECT_EQ(found.best.node, expected.best.node);
  EXPECT_EQ(found.best.similarity, expected.best.similarity);
  EXPECT_EQ(found.runner_up.node, expected.runner_up.node);
  EXPECT_EQ(found.runner_up.similarity, expected.runner_up.similarity);
}

TEST(PlaceIndex, SaysWhatTheExhaustiveScanSaysOnRandomMaps) {
  for (std::uint64_t seed = first_seed(); seed < first_seed() + 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomMaps random(seed);
    const RandomMaps::Map map = random.map(1 + random.below(400), random.chance(0.4));
    PlaceIndex index;
    for (const PlaceIndex::Entry& entry : map.order) {
      index.add(entry, map.nodes[static_cast<std::size_t>(entry.node)][static_cast<std::size_t>(entry.view)]);
    }
    for (int i = 0; i < 4; ++i) {
      const Signature query = random.another(map);
      const MatchConfig config = random.config();
      const int same_place = random.same_place_nodes();
      const int nodes = static_cast<int>(map.nodes.size());
      const int admissible = random.chance(0.5) ? nodes : 1 + random.below(nodes);
      const double at_least = random.at_least();
      expect_same(indexed(index, query, map.nodes, admissible, same_place, config, at_least),
                  exhaustive(query, map.nodes, admissible, same_place, config, at_least));
    }
    if (HasFailure()) return;
  }
}

TEST(PlaceIndex, SaysWhatTheExhaustiveScanSaysOnALongWay) {
  testing::SimulatedWay way(first_seed());
  testing::SimulatedWay elsewhere(first_seed() + 1);
  std::vector<Signature> signatures;
  for (int i = 0; i < 3000; ++i) signatures.push_back(way.next());
  const std::vector<Views> nodes = nodes_of(signatures);
  const PlaceIndex index = index_of(nodes);
  for (int i = 0; i < 12; ++i) {
    const bool loop = i % 2 == 0;
    const Signature query =
        loop ? way.revisited(signatures[static_cast<std::size_t>(250 * i)]) : elsewhere.next();
    MatchConfig config;
    config.method = i % 4 < 2 ? Method::paper_weighted : Method::paper;
    const Ranking expected = exhaustive(query, nodes, 3000, 5, config);
    if (loop && config.method == Method::paper_weighted) {
      EXPECT_NEAR(expected.best.node, 250 * i, 5);  // or the case is not what it is meant to be
    }
    expect_same(indexed(index, query, nodes, 3000, 5, config), expected);
    for (const double at_least : {expected.runner_up.similarity, expected.best.similarity, 1e3}) {
      expect_same(indexed(index, query, nodes, 3000, 5, config, at_least),
                  exhaustive(query, nodes, 3000, 5, config, at_least));
    }
  }
}

TEST(PlaceIndex, OnTiesTheFirstNodeIsTheBest) {
  // 200 images of the same place: all similarities are the cap.
  const Signature place = testing::image_of_place(1);
  const std::vector<Views> nodes(200, Views{place});
  const PlaceIndex index = index_of(nodes);
  const Ranking found = indexed(index, place, nodes, 200, 5, {});
  EXPECT_EQ(found.best, (Candidate{0, 1e6}));
  EXPECT_EQ(found.runner_up, (Candidate{6, 1e6}));
}

TEST(PlaceIndex, WhereNothingMatchesTheFirstNodesRank) {
  const Signature left = testing::signature({testing::region(0, 0, 1)});
  const std::vector<Views> nodes(100, Views{testing::signature({testing::region(296, 396, 1)})});
  const PlaceIndex index = index_of(nodes);
  const Ranking expected{{0, 0}, {6, 0}};
  EXPECT_EQ(indexed(index, left, nodes, 100, 5, {}), expected);
  EXPECT_EQ(indexed(index, testing::signature({}), nodes, 100, 5, {}), expected);
  EXPECT_EQ(indexed(index, left, nodes, 4, 5, {}), (Ranking{{0, 0}, {-1, 0}}));
  EXPECT_EQ(indexed(index, left, nodes, 0, 5, {}), Ranking{});
}

TEST(PlaceIndex, WhatIsLessSimilarThanAskedForCountsAsNone) {
  std::vector<Views> nodes;
  for (int i = 0; i < 150; ++i) nodes.push_back({testing::image_of_place(i)});
  const PlaceIndex index = index_of(nodes);
  const Signature query = testing::image_of_place(42);
  const Ranking all = indexed(index, query, nodes, 150, 0, {});
  ASSERT_GE(all.runner_up.node, 0);
  EXPECT_EQ(indexed(index, query, nodes, 150, 0, {}, all.runner_up.similarity), all);
  EXPECT_EQ(indexed(index, query, nodes, 150, 0, {}, 1e6), (Ranking{{42, 1e6}, {}}));
  EXPECT_EQ(indexed(index, query, nodes, 150, 0, {}, 1.1e6), Ranking{});
  EXPECT_EQ(indexed(index, testing::signature({}), nodes, 150, 0, {}, 1e-9), Ranking{});
}

TEST(PlaceIndex, NodesBeyondTheAdmissibleAreNotFound) {
  std::vector<Views> nodes;
  for (int i = 0; i < 150; ++i) nodes.push_back({testing::image_of_place(i)});
  const PlaceIndex index = index_of(nodes);
  EXPECT_EQ(indexed(index, testing::image_of_place(140), nodes, 150, 0, {}).best, (Candidate{140, 1e6}));
  EXPECT_EQ(indexed(index, testing::image_of_place(140), nodes, 140, 0, {}).best.node, 139);
}

TEST(PlaceIndex, ANodeIsAsSimilarAsTheMostSimilarOfItsViews) {
  std::vector<Views> nodes;
  for (int i = 0; i < 100; ++i)
    nodes.push_back({testing::image_of_place(i), testing::image_of_place(1000 + i)});
  const PlaceIndex index = index_of(nodes);
  EXPECT_EQ(index.size(), 200U);
  EXPECT_EQ(indexed(index, testing::image_of_place(1042), nodes, 100, 0, {}).best, (Candidate{42, 1e6}));
}

TEST(PlaceIndex, ACopyHasItsOwnEntries) {
  std::vector<Views> nodes = {{testing::image_of_place(0)}, {testing::image_of_place(1)}};
  PlaceIndex index;
  index.add({0, 0}, nodes[0][0]);
  PlaceIndex copy = index;
  copy.add({1, 0}, nodes[1][0]);
  EXPECT_EQ(index.size(), 1U);
  EXPECT_EQ(indexed(copy, nodes[1][0], nodes, 2, 0, {}).best, (Candidate{1, 1e6}));
}

TEST(PlaceIndex, RefusesWhatMatchRefuses) {
  const std::vector<Views> nodes = {{testing::image_of_place(0)}};
  PlaceIndex index = index_of(nodes);
  Signature other = testing::image_of_place(0);
  other.width = 301;
  EXPECT_THROW(index.add({1, 0}, other), Error);
  EXPECT_EQ(index.size(), 1U);
  EXPECT_THROW(indexed(index, other, nodes, 1, 5, {}), Error);
  const auto fault = [&](auto change) {
    MatchConfig config;
    change(config);
    EXPECT_THROW(indexed(index, testing::image_of_place(0), nodes, 1, 5, config), Error);
  };
  fault([](MatchConfig& c) { c.search_radius = 0; });
  fault([](MatchConfig& c) { c.displacement_tolerance = std::numeric_limits<double>::quiet_NaN(); });
  fault([](MatchConfig& c) { c.similarity_cap = -1; });
}

TEST(PlaceIndex, TakesLittleMemory) {
  testing::SimulatedWay way(3);
  PlaceIndex index;
  constexpr int count = 6400;
  for (int i = 0; i < count; ++i) index.add({i, 0}, way.next());
  // With twenty regions of 48 bytes below 1.2 KiB.
  EXPECT_LT(static_cast<double>(index.memory()) / count,
            1.2 * 1024 - 20 * sizeof(Region) - sizeof(Signature));
}

}  // namespace
}  // namespace sailmap
