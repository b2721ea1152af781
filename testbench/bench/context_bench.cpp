// Method context: describing an image's maps, matching two images, and a query against 1000 to 100 000
// images.
//
// `context/describe` at VGA (maps of 160 x 120), without the front end; `context/query/N` proposes by N
// layouts and matches 40; one thread. Counter `bytes`: memory an image.
#include <benchmark/benchmark.h>

#include <random>
#include <string>
#include <vector>

#include "bench.hpp"
#include "host/context/synthetic_maps.hpp"
#include "sailmap/context.hpp"

namespace sailmap::bench {
namespace {

// Raw integers, as the fixed-point front ends give them.
Maps integer_maps(unsigned place) {
  Maps maps = testing::scene_maps(place);
  const auto convert = [](Map& map) {
    const Plane<double> values = map.values();
    Plane<std::uint32_t> raw(values.width(), values.height());
    for (std::size_t i = 0; i < raw.samples().size(); ++i) {
      raw.samples()[i] = static_cast<std::uint32_t>(values.samples()[i] * 65536);
    }
    map.samples = std::move(raw);
  };
  for (Map& map : maps.features) convert(map);
  convert(maps.saliency);
  return maps;
}

// Images of random places: layouts of random bits, regions of a few scenes.
std::vector<PlaceDescriptor> random_places(std::size_t count) {
  std::vector<PlaceDescriptor> scenes;
  for (unsigned place = 0; place < 16; ++place) scenes.push_back(describe_place(testing::scene_maps(place)));
  std::mt19937_64 random(1);
  std::vector<PlaceDescriptor> out;
  for (std::size_t i = 0; i < count; ++i) {
    out.push_back(scenes[i % scenes.size()]);
    for (auto& column : out.back().layout.words) {
      column[0] ^= random() & random();
      column[1] ^= random() & random() & 0x00FFFFFFFFFFFFFFU;
    }
  }
  return out;
}

void describe_image(benchmark::State& state) {
  const Maps maps = integer_maps(1);
  for (auto _ : state) benchmark::DoNotOptimize(describe_place(maps));
}

void match_pair(benchmark::State& state) {
  const PlaceDescriptor a = describe_place(testing::scene_maps(1));
  const PlaceDescriptor b = describe_place(testing::scene_maps(2));
  for (auto _ : state) benchmark::DoNotOptimize(match_contexts(a, b));
  state.counters["bytes"] =
      static_cast<double>(sizeof(PlaceDescriptor) + a.regions.size() * sizeof(ContextRegion));
}

void query(benchmark::State& state) {
  const auto places = random_places(static_cast<std::size_t>(state.range(0)));
  std::vector<const PlaceDescriptor*> candidates;
  for (const PlaceDescriptor& place : places) candidates.push_back(&place);
  const PlaceDescriptor image = describe_place(testing::scene_maps(3, 10));
  for (auto _ : state) benchmark::DoNotOptimize(score_contexts(image, candidates));
}

}  // namespace

void register_context() {
  benchmark::RegisterBenchmark("context/describe", describe_image)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("context/match", match_pair)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("context/query", query)
      ->Arg(1000)
      ->Arg(20000)
      ->Arg(100000)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace sailmap::bench
