// Maps of 1000 to 1 000 000 nodes of twenty regions: a query through the index and through the exhaustive
// scan, insertion, one pair.
//
// `query/...` is the hard case, an image of no place in the map, on a simulated way; `query_loop/...` one of
// a place in the map; `query_resampled/...` the hard case on a map resampled from real images. These ask
// for the most similar nodes; `as_run/...` and so on ask what `run` asks, on large maps only what can close a
// loop. Counters: bytes a node (index and signature), and the mean similarity of the best.
#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <vector>

#include "bench.hpp"
#include "resampled_images.hpp"
#include "sailmap/place_index.hpp"
#include "simulated_signatures.hpp"

namespace sailmap::bench {
namespace {

constexpr int same_place_nodes = 5;
constexpr std::size_t query_count = 32;

enum class Source { way, resampled };

// What is asked: the most similar nodes, however little that is, or what `run` asks, which is the same up to
// DetectionConfig::ranked_nodes, and only what can close a loop beyond.
enum class Asked { ranking, as_run };

// The first nodes are the same for every size. One source and one index are kept at a time: a million nodes
// take more than a gigabyte.
class Maps {
 public:
  static Maps& instance() {
    static Maps maps;
    return maps;
  }

  const std::vector<Signature>& nodes(Source source, std::size_t count) {
    if (source != source_) *this = Maps(source);
    if (nodes_.capacity() < count) nodes_.reserve(count);
    while (nodes_.size() < count) nodes_.push_back(source_ == Source::way ? way_.next() : resampled_->next());
    return nodes_;
  }

  const PlaceIndex& index(Source source, std::size_t count) {
    nodes(source, count);
    if (index_.size() > count) index_ = PlaceIndex();
    while (index_.size() < count) {
      const std::size_t i = index_.size();
      index_.add({static_cast<int>(i), 0}, nodes_[i]);
    }
    return index_;
  }

  // Of no place in the map, or of places all over it.
  std::vector<Signature> queries(Source source, std::size_t count, bool loops) {
    nodes(source, count);
    if (source_ == Source::resampled) return resampled_->queries();
    std::vector<Signature> out;
    for (std::size_t i = 0; i < query_count; ++i) {
      if (loops) {
        out.push_back(way_.revisited(nodes_[(2 * i + 1) * count / (2 * query_count)]));
      } else {
        for (int step = 0; step < 50; ++step) elsewhere_.next();  // as far as new surroundings
        out.push_back(elsewhere_.next());
      }
    }
    return out;
  }

 private:
  explicit Maps(Source source = Source::way) : source_(source) {
    if (source == Source::resampled) resampled_ = std::make_unique<ResampledImages>();
  }

  Source source_;
  testing::SimulatedWay way_{1};
  testing::SimulatedWay elsewhere_{2};
  std::unique_ptr<ResampledImages> resampled_;
  std::vector<Signature> nodes_;
  PlaceIndex index_;
};

MatchConfig config_of(Method method) {
  MatchConfig config;
  config.method = method;
  return config;
}

// In batches of `batch` queries.
template <class Find>
void run_queries(benchmark::State& state, const std::vector<Signature>& queries, std::size_t batch,
                 const Find& find) {
  std::size_t next = 0;
  double similarities = 0;
  while (state.KeepRunningBatch(static_cast<benchmark::IterationCount>(batch))) {
    for (std::size_t i = 0; i < batch; ++i, ++next) {
      similarities += find(queries[next % queries.size()]).best.similarity;
    }
  }
  state.counters["best_similarity"] = similarities / static_cast<double>(next);
  state.SetItemsProcessed(state.iterations());
}

void query(benchmark::State& state, Asked asked, Method method, Source source, bool loops) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const auto& nodes = Maps::instance().nodes(source, count);
  const PlaceIndex& index = Maps::instance().index(source, count);
  const MatchConfig config = config_of(method);
  DetectionConfig detection;
  detection.threshold = default_threshold(method);
  PlaceIndex::Question question = {static_cast<int>(count), same_place_nodes, 0};
  if (asked == Asked::as_run && question.nodes > detection.ranked_nodes) {
    question.at_least = least_that_matters(detection);
  }
  // All queries equally often: their times differ.
  const std::vector<Signature> queries = Maps::instance().queries(source, count, loops);
  run_queries(state, queries, queries.size(), [&](const Signature& image) {
    return index.find(image, question, config, [&nodes](const PlaceIndex::Entry& entry) -> const Signature& {
      return nodes[static_cast<std::size_t>(entry.node)];
    });
  });
  const double signatures = static_cast<double>(count) * (sizeof(Signature) + 20 * sizeof(Region));
  // What screening asks for at least and at most: each node's codes read once, each pair of regions compared
  // (eight products and sums).
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(index.memory()));
  state.counters["operations"] = benchmark::Counter(static_cast<double>(count) * 20 * 20 * 8 * 2,
                                                    benchmark::Counter::kIsIterationInvariantRate);
  state.counters["bytes_per_node"] =
      (static_cast<double>(index.memory()) + signatures) / static_cast<double>(count);
}

void query_exhaustive(benchmark::State& state, Method method) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const auto& nodes = Maps::instance().nodes(Source::way, count);
  const MatchConfig config = config_of(method);
  run_queries(state, Maps::instance().queries(Source::way, count, false), 1, [&](const Signature& image) {
    std::vector<Candidate> candidates;
    candidates.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      candidates.push_back({static_cast<int>(i), match(image, nodes[i], config).similarity});
    }
    return rank(candidates, same_place_nodes);
  });
}

void insert(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const auto& nodes = Maps::instance().nodes(Source::way, count);
  PlaceIndex index = Maps::instance().index(Source::way, count);
  for ([[maybe_unused]] auto _ : state) {
    index.add({static_cast<int>(index.size()), 0}, nodes[index.size() % count]);
  }
  state.SetItemsProcessed(state.iterations());
}

void match_pair(benchmark::State& state) {
  const auto& nodes = Maps::instance().nodes(Source::way, 1000);
  std::size_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(match(nodes[0], nodes[i % 1000], {}));
    ++i;
  }
}

}  // namespace

void register_query() {
  const auto sizes = [](benchmark::internal::Benchmark* of,
                        benchmark::TimeUnit unit = benchmark::kMillisecond) {
    for (const int nodes : {1000, 10000, 100000, 1000000}) of->Arg(nodes);
    of->Unit(unit);
  };
  const auto queries = [&](const std::string& kind, Method method, Source source, bool loops) {
    for (const auto& [what, asked] : {std::pair("query", Asked::ranking), {"as_run", Asked::as_run}}) {
      const std::string of = what + kind + "/" + std::string(sailmap::name(method));
      sizes(benchmark::RegisterBenchmark(of.c_str(), [=, asked = asked](benchmark::State& state) {
        query(state, asked, method, source, loops);
      }));
    }
  };
  benchmark::RegisterBenchmark("match/pair", match_pair);
  for (const Method method : {Method::paper_weighted, Method::paper}) {
    const std::string name(sailmap::name(method));
    queries("", method, Source::way, false);
    queries("_loop", method, Source::way, true);
    sizes(
        benchmark::RegisterBenchmark(("query_exhaustive/" + name).c_str(),
                                     [method](benchmark::State& state) { query_exhaustive(state, method); }));
  }
  sizes(benchmark::RegisterBenchmark("insert", insert), benchmark::kMicrosecond);
  if (!ResampledImages::available()) return;
  for (const Method method : {Method::paper_weighted, Method::paper}) {
    queries("_resampled", method, Source::resampled, false);
  }
}

}  // namespace sailmap::bench
