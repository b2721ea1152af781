// The map file: saving and loading maps of 1000, 10 000 and 100 000 nodes of twenty regions. Counter `bytes_per_node`:
// of the file.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "bench.hpp"
#include "sailmap/map_store.hpp"
#include "simulated_signatures.hpp"

namespace sailmap::bench {
namespace {

// A way without a loop, one image a node.
TopologicalMap way(int nodes) {
  testing::SimulatedWay simulated(3);
  std::vector<Node> out;
  std::vector<Edge> edges;
  std::vector<Update> history;
  for (int i = 0; i < nodes; ++i) {
    const std::string name = "images/" + std::to_string(i) + ".png";
    out.push_back({i, {{i, name, simulated.next()}}});
    if (i > 0) edges.push_back({i - 1, i, EdgeKind::path});
    history.push_back({i, name, i, true, {}});
  }
  return {MapConfig{}, std::move(out), std::move(edges), std::move(history), nodes - 1};
}

// Removed with what it holds.
struct Folder {
  std::filesystem::path path = std::filesystem::temp_directory_path() / "sailmap_bench_map";
  Folder() { std::filesystem::create_directories(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path); }
};

void save(benchmark::State& state) {
  const Folder folder;
  const auto store = open_map_store(folder.path / "map.sailmap");
  const TopologicalMap map = way(static_cast<int>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) store->save(map, "fixed");
  state.counters["bytes_per_node"] =
      static_cast<double>(std::filesystem::file_size(folder.path / "map.sailmap")) /
      static_cast<double>(state.range(0));
}

void load(benchmark::State& state) {
  const Folder folder;
  const auto store = open_map_store(folder.path / "map.sailmap");
  store->save(way(static_cast<int>(state.range(0))), "fixed");
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(store->load());
}

}  // namespace

void register_map() {
  for (const int nodes : {1000, 10000, 100000}) {
    benchmark::RegisterBenchmark("map/save", save)->Arg(nodes)->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("map/load", load)->Arg(nodes)->Unit(benchmark::kMillisecond);
  }
}

}  // namespace sailmap::bench
