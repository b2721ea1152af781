// What bounds a query of a large map: screening and the estimate behind it, each alone, and how many images
// which bound leaves to be looked at when the runner-up is already known.
//
// Counters: `passing`, the part of the images that screening leaves; `passing_exact`, what it would leave if
// its codes were exact (constraint 1 and exact distances), and `fours_passing_exact`, what part of the groups
// of four consecutive images a bound that they share would leave; `reaching`, those that truly reach the
// runner-up; `pairs`, the part of all pairs of regions that are within reach by the columns of their slots,
// and `pairs_in_order`, what it would be if images shared blocks in the order in which they come.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <bit>
#include <string>
#include <vector>

#include "bench.hpp"
#include "index/estimate.hpp"
#include "index/grouping.hpp"
#include "index/screen.hpp"
#include "resampled_images.hpp"
#include "sailmap/place_index.hpp"
#include "simulated_signatures.hpp"

namespace sailmap::bench {
namespace {

constexpr std::size_t node_count = 20000;
constexpr std::size_t query_count = 12;
constexpr int same_place_nodes = 5;

struct Images {
  std::vector<Signature> nodes;
  std::vector<Signature> queries;
};

Images simulated_images() {
  Images out;
  testing::SimulatedWay way{1};
  testing::SimulatedWay elsewhere{2};
  while (out.nodes.size() < node_count) out.nodes.push_back(way.next());
  while (out.queries.size() < query_count) {
    for (int step = 0; step < 50; ++step) elsewhere.next();  // as far as new surroundings
    out.queries.push_back(elsewhere.next());
  }
  return out;
}

Images resampled_images() {
  Images out;
  ResampledImages images;
  while (out.nodes.size() < node_count) out.nodes.push_back(images.next());
  out.queries = images.queries();
  out.queries.resize(std::min(out.queries.size(), query_count));
  return out;
}

std::vector<index::Block> blocks_in_order(const std::vector<Signature>& nodes) {
  std::vector<index::Block> blocks((nodes.size() + index::block_images - 1) / index::block_images);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    blocks[i / index::block_images].add(i % index::block_images, nodes[i]);
  }
  return blocks;
}

std::vector<index::Block> blocks_of(const std::vector<Signature>& nodes) {
  index::Grouping grouping;
  std::vector<index::Block> blocks;
  for (const Signature& node : nodes) {
    const index::Grouping::Place place = grouping.add(index::column_keys(node));
    blocks.resize(grouping.blocks());
    blocks[place.block].add(place.lane, node);
  }
  return blocks;
}

// The part of all pairs that are looked at, two regions of the query at a time.
double pairs_within_reach(const std::vector<index::ScreenQuery>& screens,
                          const std::vector<index::Block>& blocks) {
  double within = 0;
  double all = 0;
  for (const index::ScreenQuery& screen : screens) {
    for (const index::Block& block : blocks) {
      for (std::size_t i = 0; i < screen.regions.size(); i += 2) {
        const index::ScreenRegion& first = screen.regions[i];
        const index::ScreenRegion& second = screen.regions[std::min(i + 1, screen.regions.size() - 1)];
        const std::uint8_t begin = std::min(first.first_column, second.first_column);
        const std::uint8_t end = std::max(first.last_column, second.last_column);
        for (const index::Columns& columns : block.columns) {
          for (std::size_t slot = 0; slot < block.slots(); ++slot) {
            within += columns.last[slot] >= begin && columns.first[slot] <= end ? 1 : 0;
            ++all;
          }
        }
      }
    }
  }
  return within / all;
}

double runner_up(const Signature& query, const std::vector<Signature>& nodes, const MatchConfig& config) {
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    candidates.push_back({static_cast<int>(i), match(query, nodes[i], config).similarity});
  }
  return rank(candidates, same_place_nodes).runner_up.similarity;
}

// The regions of so many nodes from `first` on, as if they were one.
Signature joined(const std::vector<Signature>& nodes, std::size_t first, std::size_t count) {
  Signature out = nodes[first];
  for (std::size_t i = first + 1; i < first + count; ++i) {
    out.regions.insert(out.regions.end(), nodes[i].regions.begin(), nodes[i].regions.end());
  }
  return out;
}

// The most eq. 7 can be by constraint 1 alone, for a node or several.
double exact_bound(const Signature& query, const Signature& node, const MatchConfig& config) {
  std::vector<RegionMatch> matches = nearest_matches(query, node, config);
  std::sort(matches.begin(), matches.end(),
            [](const RegionMatch& a, const RegionMatch& b) { return a.distance < b.distance; });
  double sum = 0;
  double most = 0;
  double matched = 0;
  for (const RegionMatch& match : matches) {
    sum += match.distance;
    ++matched;
    const auto regions = static_cast<double>(query.regions.size());
    most = std::max(most, (config.method == Method::paper ? 1 : matched / regions) * matched / sum);
  }
  return most;
}

struct Shares {
  double passing = 0;
  double passing_exact = 0;
  double fours_passing_exact = 0;
  double reaching = 0;
};

Shares shares(const Images& images, const std::vector<index::Block>& blocks, const MatchConfig& config,
              std::vector<index::ScreenQuery>& screens) {
  Shares out;
  for (std::size_t i = 0; i < images.queries.size(); ++i) {
    const Signature& query = images.queries[i];
    const double threshold = runner_up(query, images.nodes, config);
    screens.emplace_back(query, config).set_threshold(threshold);
    for (const index::Block& block : blocks) out.passing += std::popcount(screens.back().passing(block));
    for (const Signature& node : images.nodes) {
      out.passing_exact += exact_bound(query, node, config) >= threshold ? 1 : 0;
      out.reaching += match(query, node, config).similarity >= threshold ? 1 : 0;
    }
    for (std::size_t first = 0; first + 4 <= images.nodes.size(); first += 4) {
      const Signature four = joined(images.nodes, first, 4);
      out.fours_passing_exact += exact_bound(query, four, config) >= threshold ? 4 : 0;
    }
  }
  const auto all = static_cast<double>(images.nodes.size() * images.queries.size());
  return {out.passing / all, out.passing_exact / all, out.fours_passing_exact / all, out.reaching / all};
}

void screen(benchmark::State& state, Images (*images_of)(), Method method) {
  const Images images = images_of();
  const std::vector<index::Block> blocks = blocks_of(images.nodes);
  MatchConfig config;
  config.method = method;
  std::vector<index::ScreenQuery> screens;
  const Shares found = shares(images, blocks, config, screens);
  std::size_t next = 0;
  while (state.KeepRunningBatch(index::block_images)) {
    benchmark::DoNotOptimize(
        screens[next / blocks.size() % screens.size()].passing(blocks[next % blocks.size()]));
    ++next;
  }
  state.counters["pairs"] = pairs_within_reach(screens, blocks);
  state.counters["pairs_in_order"] = pairs_within_reach(screens, blocks_in_order(images.nodes));
  state.counters["passing"] = found.passing;
  state.counters["passing_exact"] = found.passing_exact;
  state.counters["fours_passing_exact"] = found.fours_passing_exact;
  state.counters["reaching"] = found.reaching;
}

void estimate(benchmark::State& state) {
  const Images images = simulated_images();
  index::Estimator estimator(images.queries.front(), {});
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(estimator(images.nodes[next++ % 1000]));
  }
}

}  // namespace

void register_screen() {
  for (const Method method : {Method::paper_weighted, Method::paper}) {
    const std::string name(sailmap::name(method));
    benchmark::RegisterBenchmark(("screen/way/" + name).c_str(), [method](benchmark::State& state) {
      screen(state, simulated_images, method);
    });
    if (!ResampledImages::available()) continue;
    benchmark::RegisterBenchmark(("screen/resampled/" + name).c_str(), [method](benchmark::State& state) {
      screen(state, resampled_images, method);
    });
  }
  benchmark::RegisterBenchmark("estimate/pair", estimate);
}

}  // namespace sailmap::bench
