// Maps built with the index against maps built without, dense and sparse, simulated and real.
#include <gmock/gmock.h>

#include "host/index/exhaustive.hpp"
#include "host/index/random_maps.hpp"
#include "sailmap/frontend.hpp"
#include "sailmap/image_source.hpp"
#include "sailmap/topological_map.hpp"
#include "sailmap_data.hpp"
#include "simulated_signatures.hpp"

namespace sailmap {
namespace {

// Spec section 11 once more, with lists instead of an index and of anything else that is quick.
struct SlowMap {
  MapConfig config;
  std::vector<testing::Views> nodes;
  std::vector<int> first_images;
  std::vector<Edge> edges;
  int images = 0;
  int active = -1;

  void connect(int from, int to, EdgeKind kind) {
    for (const Edge& edge : edges) {
      const bool same = (edge.from == from && edge.to == to) || (edge.from == to && edge.to == from);
      if (edge.kind == kind && same) return;
    }
    edges.push_back({from, to, kind});
  }

  Ranking add(const Signature& image) {
    int admissible = 0;
    while (admissible < static_cast<int>(nodes.size()) &&
           images - first_images[static_cast<std::size_t>(admissible)] > config.exclude_recent) {
      ++admissible;
    }
    const double at_least =
        admissible > config.detection.ranked_nodes ? least_that_matters(config.detection) : 0;
    const Ranking ranking = testing::exhaustive(image, nodes, admissible, config.detection.same_place_nodes,
                                                config.match, at_least);
    const bool rivalled =
        ranking.runner_up.node >= 0 &&
        ranking.runner_up.similarity >= config.detection.ambiguity_ratio * ranking.best.similarity;
    const bool loop = ranking.best.similarity > config.detection.threshold && !rivalled;
    if (loop) {
      if (ranking.best.node != active) connect(active, ranking.best.node, EdgeKind::loop);
      active = ranking.best.node;
      if (config.sparse) nodes[static_cast<std::size_t>(active)].push_back(image);
    } else if (config.sparse && active >= 0 &&
               testing::similarity(image, nodes[static_cast<std::size_t>(active)], config.match) >
                   config.sparse_threshold) {
      nodes[static_cast<std::size_t>(active)].push_back(image);
    } else {
      nodes.push_back({image});
      first_images.push_back(images);
      if (active >= 0) connect(active, static_cast<int>(nodes.size()) - 1, EdgeKind::path);
      active = static_cast<int>(nodes.size()) - 1;
    }
    ++images;
    return ranking;
  }
};

MapConfig config_of(Method method, bool sparse) {
  MapConfig config;
  config.match.method = method;
  config.detection.threshold = default_threshold(method);
  config.sparse = sparse;
  config.sparse_threshold = 0.8 * config.detection.threshold;
  config.exclude_recent = 10;
  return config;
}

// Half of the images again on the way back; the map is stored and restored once on the way.
void compare_maps(const std::vector<Signature>& images, const MapConfig& config) {
  TopologicalMap map(config);
  SlowMap slow;
  slow.config = config;
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (i == images.size() / 2) {
      map = TopologicalMap(config, map.nodes(), map.edges(), map.history(), map.active());
    }
    const Ranking expected = slow.add(images[i]);
    const Update& update = map.add("image", images[i]);
    ASSERT_EQ(update.detection.best, expected.best) << i;
    ASSERT_EQ(update.detection.runner_up, expected.runner_up) << i;
    ASSERT_EQ(map.active(), slow.active) << i;
  }
  EXPECT_EQ(map.edges(), slow.edges);
  ASSERT_EQ(map.nodes().size(), slow.nodes.size());
  for (std::size_t n = 0; n < slow.nodes.size(); ++n) {
    EXPECT_EQ(map.nodes()[n].views.size(), slow.nodes[n].size());
  }
}

// There and back.
std::vector<Signature> there_and_back(std::size_t length) {
  testing::SimulatedWay way(17);
  std::vector<Signature> images;
  while (images.size() < length) images.push_back(way.next());
  for (std::size_t i = length; i > 1; i -= 2) images.push_back(way.revisited(images[i - 1]));
  return images;
}

TEST(IndexedMap, GrowsAsOneThatComparesAll) {
  const std::vector<Signature> images = there_and_back(250);
  for (const bool sparse : {false, true}) {
    for (const Method method : {Method::paper, Method::paper_weighted}) {
      compare_maps(images, config_of(method, sparse));
    }
  }
}

TEST(IndexedMap, SearchedForLoopsOnlyIsTheSameMap) {
  const std::vector<Signature> images = there_and_back(250);
  for (const Method method : {Method::paper, Method::paper_weighted}) {
    for (const double ratio : {2.0, 0.8}) {
      MapConfig config = config_of(method, false);
      config.detection.ambiguity_ratio = ratio;
      config.detection.threshold = method == Method::paper ? 10 : 3;
      TopologicalMap all(config);
      config.detection.ranked_nodes = 60;
      compare_maps(images, config);
      TopologicalMap loops_only(config);
      int without_best = 0;
      for (std::size_t i = 0; i < images.size(); ++i) {
        const Update& expected = all.add("image", images[i]);
        const Update& update = loops_only.add("image", images[i]);
        ASSERT_EQ(update.detection.reason, expected.detection.reason) << i;
        ASSERT_EQ(update.node, expected.node) << i;
        if (update.detection.best.node < 0 && i > 0) {
          ++without_best;
          EXPECT_TRUE(i <= 10 || i > 60) << i;
        } else {
          EXPECT_EQ(update.detection.best, expected.detection.best) << i;
          EXPECT_EQ(update.detection.matches.size(), expected.detection.matches.size()) << i;
        }
      }
      EXPECT_EQ(loops_only.edges(), all.edges());
      EXPECT_GT(loops_only.loops(), 20);
      EXPECT_GT(without_best, 100);
    }
  }
}

TEST(IndexedMap, GrowsAsOneThatComparesAllOnRealImages) {
  SAILMAP_NEEDS_DATA("rtabmap_corridor/images");
  const auto paths = list_images((testing::data_folder() / "rtabmap_corridor/images").string());
  const auto frontend = make_frontend("quantised");
  Maps maps;
  std::vector<Signature> images;
  for (std::size_t i = 0; i < paths.size(); i += 2) {
    frontend->compute(view_of(read_image(paths[i])), maps);
    images.push_back(make_signature(maps, {}));
  }
  ASSERT_GE(images.size(), 40U);
  for (const bool sparse : {false, true}) {
    for (const Method method : {Method::paper, Method::paper_weighted}) {
      MapConfig config = config_of(method, sparse);
      config.exclude_recent = 5;
      compare_maps(images, config);
    }
  }
}

}  // namespace
}  // namespace sailmap
