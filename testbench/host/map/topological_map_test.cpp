// Spec section 11: how the map grows, by hand.
#include "sailmap/topological_map.hpp"

#include <gmock/gmock.h>

#include "host/map_builders.hpp"
#include "sailmap/error.hpp"

namespace sailmap {
namespace {

using ::testing::ElementsAre;
using testing::image_of_place;
using ::testing::IsEmpty;
using testing::map_of;
using testing::small_map_config;

std::vector<Reason> reasons(const TopologicalMap& map) {
  std::vector<Reason> out;
  for (const Update& update : map.history()) out.push_back(update.detection.reason);
  return out;
}

TEST(TopologicalMap, NewPlacesMakeNodesJoinedByPathEdges) {
  const TopologicalMap map = map_of({0, 1, 2, 3});
  EXPECT_EQ(map.nodes().size(), 4U);
  EXPECT_THAT(map.edges(), ElementsAre(Edge{0, 1, EdgeKind::path}, Edge{1, 2, EdgeKind::path},
                                       Edge{2, 3, EdgeKind::path}));
  EXPECT_THAT(reasons(map),
              ElementsAre(Reason::no_nodes, Reason::excluded, Reason::excluded, Reason::below_threshold));
  EXPECT_EQ(map.active(), 3);
  EXPECT_EQ(map.loops(), 0);
}

TEST(TopologicalMap, AKnownPlaceClosesALoopAndBecomesActive) {
  const TopologicalMap map = map_of({0, 1, 2, 3, 1, 4});
  const Detection& loop = map.history()[4].detection;
  EXPECT_TRUE(loop.accepted());
  EXPECT_EQ(loop.best.node, 1);
  EXPECT_EQ(loop.matches.size(), 3U);
  EXPECT_EQ(map.loops(), 1);
  EXPECT_EQ(map.nodes().size(), 5U);
  EXPECT_THAT(map.edges(),
              ElementsAre(Edge{0, 1, EdgeKind::path}, Edge{1, 2, EdgeKind::path}, Edge{2, 3, EdgeKind::path},
                          Edge{3, 1, EdgeKind::loop}, Edge{1, 4, EdgeKind::path}));
}

TEST(TopologicalMap, StrictPaperModeHasNoLoopEdges) {
  MapConfig config = small_map_config();
  config.loop_edges = false;
  const TopologicalMap map = map_of({0, 1, 2, 3, 1, 4}, config);
  EXPECT_EQ(map.loops(), 1);
  EXPECT_THAT(map.edges(), ElementsAre(Edge{0, 1, EdgeKind::path}, Edge{1, 2, EdgeKind::path},
                                       Edge{2, 3, EdgeKind::path}, Edge{1, 4, EdgeKind::path}));
}

TEST(TopologicalMap, RecentNodesAreNotCompared) {
  // Place 1 again two images later is excluded, three later is a loop.
  EXPECT_EQ(map_of({0, 1, 2, 1}).loops(), 0);
  EXPECT_EQ(map_of({0, 1, 2, 3, 1}).loops(), 1);
  MapConfig config = small_map_config();
  config.exclude_recent = 0;
  EXPECT_EQ(map_of({0, 0}, config).loops(), 1);
}

TEST(TopologicalMap, RecencyIsCountedInImagesAlsoAfterLoops) {
  // The second lap makes no nodes; nodes of the first lap must not stay "recent" for ever.
  EXPECT_EQ(map_of({0, 1, 2, 3, 0, 1, 2, 3}).loops(), 4);
}

TEST(TopologicalMap, AnEdgeIsKeptOnce) {
  // Loops 4-0, 0-3, 3-0, 0-3: the last two are the second edge again.
  const TopologicalMap map = map_of({0, 1, 2, 3, 4, 0, 3, 0, 3});
  EXPECT_EQ(map.loops(), 4);
  EXPECT_EQ(map.edges().size(), 4U + 2U);
}

TEST(TopologicalMap, SparseNodesHoldGroupsOfImages) {
  MapConfig config = small_map_config();
  config.sparse = true;
  const TopologicalMap map = map_of({0, 0, 1, 1, 1, 2, 2, 3, 0, 0, 1}, config);
  ASSERT_EQ(map.nodes().size(), 4U);
  std::vector<std::size_t> views;
  for (const Node& node : map.nodes()) views.push_back(node.views.size());
  EXPECT_THAT(views, ElementsAre(4, 4, 2, 1));
  EXPECT_EQ(map.active(), 1);
  EXPECT_THAT(map.edges(),
              ElementsAre(Edge{0, 1, EdgeKind::path}, Edge{1, 2, EdgeKind::path}, Edge{2, 3, EdgeKind::path},
                          Edge{3, 0, EdgeKind::loop}, Edge{0, 1, EdgeKind::loop}));
}

TEST(TopologicalMap, FlatImagesAreNeverALoop) {
  TopologicalMap map(small_map_config());
  for (int i = 0; i < 5; ++i) map.add("flat", testing::signature({}));
  EXPECT_EQ(map.loops(), 0);
  EXPECT_EQ(map.nodes().size(), 5U);
  EXPECT_EQ(map.history().back().detection.reason, Reason::no_regions);
}

TEST(TopologicalMap, RefusesAnImageOfAnotherSizeAndStaysAsItWas) {
  TopologicalMap map = map_of({0, 1});
  Signature wide = image_of_place(2);
  wide.width = 640;
  try {
    map.add("wide.png", wide);
    FAIL() << "no error";
  } catch (const Error& fault) {
    EXPECT_STREQ(fault.what(), "wide.png: 640x400 pixels, but the map's images are 300x400");
  }
  EXPECT_EQ(map.images(), 2);
  EXPECT_EQ(map.nodes().size(), 2U);
}

TEST(TopologicalMap, RefusesPartsThatContradictEachOther) {
  const TopologicalMap good = map_of({0, 1, 2});
  const auto rebuilt = [&](auto change) {
    auto nodes = good.nodes();
    auto edges = good.edges();
    auto history = good.history();
    int active = good.active();
    change(nodes, edges, history, active);
    return TopologicalMap(good.config(), nodes, edges, history, active);
  };
  EXPECT_EQ(rebuilt([](auto&, auto&, auto&, int&) {}).edges(), good.edges());
  EXPECT_THROW(rebuilt([](auto& n, auto&, auto&, int&) { n[1].id = 7; }), Error);
  EXPECT_THROW(rebuilt([](auto& n, auto&, auto&, int&) { n[1].views.clear(); }), Error);
  EXPECT_THROW(rebuilt([](auto& n, auto&, auto&, int&) { n[1].views[0].image = 9; }), Error);
  EXPECT_THROW(rebuilt([](auto& n, auto&, auto&, int&) { n[1].views[0].signature.width = 9; }), Error);
  EXPECT_THROW(rebuilt([](auto&, auto& e, auto&, int&) { e[0].to = 3; }), Error);
  EXPECT_THROW(rebuilt([](auto&, auto&, auto& h, int&) { h[0].node = -1; }), Error);
  EXPECT_THROW(rebuilt([](auto&, auto&, auto&, int& a) { a = 3; }), Error);
  EXPECT_THROW(rebuilt([](auto&, auto&, auto&, int& a) { a = -1; }), Error);
}

}  // namespace
}  // namespace sailmap
