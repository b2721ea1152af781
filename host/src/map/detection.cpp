// Spec section 11: the verdict on one image.
#include "sailmap/detection.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>

#include "sailmap/error.hpp"

namespace sailmap {
namespace {

struct Entry {
  std::string_view name;
  Reason reason;
};
constexpr Entry entries[] = {{"accepted", Reason::accepted},    {"below_threshold", Reason::below_threshold},
                             {"ambiguous", Reason::ambiguous},  {"too_few_regions", Reason::too_few_regions},
                             {"excluded", Reason::excluded},    {"no_nodes", Reason::no_nodes},
                             {"no_regions", Reason::no_regions}};

Reason verdict(const Detection& detection, const DetectionConfig& config) {
  if (detection.best.similarity <= config.threshold) return Reason::below_threshold;
  if (static_cast<int>(detection.matches.size()) < config.min_matches) return Reason::too_few_regions;
  const bool rivalled = detection.runner_up.node >= 0 &&
                        detection.runner_up.similarity >= config.ambiguity_ratio * detection.best.similarity;
  return rivalled ? Reason::ambiguous : Reason::accepted;
}

}  // namespace

std::string_view name(Reason reason) {
  for (const Entry& entry : entries) {
    if (entry.reason == reason) return entry.name;
  }
  throw Error("unknown reason number " + std::to_string(static_cast<int>(reason)));
}

Reason reason_from_name(std::string_view name) {
  for (const Entry& entry : entries) {
    if (entry.name == name) return entry.reason;
  }
  throw Error("no reason '" + std::string(name) + "'");
}

double default_threshold(Method method) {
  switch (method) {
    case Method::paper:
      return DetectionConfig{}.threshold;
    case Method::paper_weighted:
      return 3;
    case Method::context:
      return 0.2;
  }
  throw Error("unknown method number " + std::to_string(static_cast<int>(method)));
}

double least_that_matters(const DetectionConfig& config) {
  return std::min(1.0, config.ambiguity_ratio) * config.threshold;
}

Ranking rank(const std::vector<Candidate>& candidates, int same_place_nodes) {
  Ranking out;
  if (candidates.empty()) return out;
  out.best = candidates.front();
  for (const Candidate& candidate : candidates) {
    if (candidate.similarity > out.best.similarity) out.best = candidate;
  }
  for (const Candidate& candidate : candidates) {
    const bool other_place = std::abs(candidate.node - out.best.node) > same_place_nodes;
    if (other_place && (out.runner_up.node < 0 || candidate.similarity > out.runner_up.similarity)) {
      out.runner_up = candidate;
    }
  }
  return out;
}

Detection decide_ranked(const Ranking& ranking, const DetectionConfig& config,
                        const std::function<std::vector<RegionMatch>(int node)>& matches_with) {
  Detection out;
  if (ranking.best.node < 0) return out;
  out.best = ranking.best;
  out.runner_up = ranking.runner_up;
  out.matches = matches_with(out.best.node);
  out.reason = verdict(out, config);
  return out;
}

Detection decide(const std::vector<Candidate>& candidates, const DetectionConfig& config,
                 const std::function<std::vector<RegionMatch>(int node)>& matches_with) {
  return decide_ranked(rank(candidates, config.same_place_nodes), config, matches_with);
}

}  // namespace sailmap
