// The map file: saving and loading maps of 1000, 10 000 and 100 000 nodes of twenty regions, and of nodes
// that the method context can use. Counter `bytes_per_node`: of the file.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bench.hpp"
#include "sailmap/map_store.hpp"
#include "simulated_signatures.hpp"

namespace sailmap::bench {
namespace {

// A place of the method context, as large as they get.
PlaceDescriptor full_place(std::mt19937_64& random) {
  PlaceDescriptor place;
  for (auto& column : place.layout.words) {
    for (std::uint64_t& word : column) word = random();
  }
  place.regions.resize(PlaceDescriptor::max_regions);
  for (ContextRegion& region : place.regions) {
    for (std::uint64_t& word : region.bits) word = random();
  }
  return place;
}

enum class Content { regions, places };

// A way without a loop, one image a node.
TopologicalMap way(int nodes, Content content) {
  testing::SimulatedWay simulated(3);
  std::mt19937_64 random(3);
  std::vector<Node> out;
  std::vector<Edge> edges;
  std::vector<Update> history;
  for (int i = 0; i < nodes; ++i) {
    const std::string name = "images/" + std::to_string(i) + ".png";
    out.push_back({i, {{i, name, simulated.next()}}});
    if (content == Content::places) out.back().views[0].signature.place = full_place(random);
    if (i > 0) edges.push_back({i - 1, i, EdgeKind::path});
    history.push_back({i, name, i, true, {}});
  }
  MapConfig config;
  if (content == Content::places) config.match.method = Method::context;
  return {config, std::move(out), std::move(edges), std::move(history), nodes - 1};
}

// Removed with what it holds.
struct Folder {
  std::filesystem::path path = std::filesystem::temp_directory_path() / "sailmap_bench_map";
  Folder() { std::filesystem::create_directories(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path); }
};

void save(benchmark::State& state, Content content) {
  const Folder folder;
  const MapStore store(folder.path / "map.sailmap");
  const TopologicalMap map = way(static_cast<int>(state.range(0)), content);
  for ([[maybe_unused]] auto _ : state) store.save(map, "fixed");
  state.counters["bytes_per_node"] =
      static_cast<double>(std::filesystem::file_size(folder.path / "map.sailmap")) /
      static_cast<double>(state.range(0));
}

void load(benchmark::State& state, Content content) {
  const Folder folder;
  const MapStore store(folder.path / "map.sailmap");
  store.save(way(static_cast<int>(state.range(0)), content), "fixed");
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(store.load());
}

}  // namespace

void register_map() {
  for (const int nodes : {1000, 10000, 100000}) {
    benchmark::RegisterBenchmark("map/save", save, Content::regions)
        ->Arg(nodes)
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("map/load", load, Content::regions)
        ->Arg(nodes)
        ->Unit(benchmark::kMillisecond);
  }
  for (const int nodes : {1000, 10000}) {
    benchmark::RegisterBenchmark("map/load_context", load, Content::places)
        ->Arg(nodes)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace sailmap::bench
