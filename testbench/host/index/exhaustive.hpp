// What the index must say: every view compared by match(), in the order of the nodes.
#pragma once

#include <vector>

#include "sailmap/detection.hpp"
#include "sailmap/place_index.hpp"
#include "sailmap/similarity.hpp"

namespace sailmap::testing {

using Views = std::vector<Signature>;  // of one node

inline double similarity(const Signature& query, const Views& node, const MatchConfig& config) {
  double best = 0;
  for (const Signature& view : node) {
    const double value = match(query, view, config).similarity;
    if (value > best) best = value;
  }
  return best;
}

inline Ranking exhaustive(const Signature& query, const std::vector<Views>& nodes, int admissible,
                          int same_place_nodes, const MatchConfig& config, double at_least = 0) {
  std::vector<Candidate> candidates;
  for (int node = 0; node < admissible; ++node) {
    const double value = similarity(query, nodes[static_cast<std::size_t>(node)], config);
    if (value >= at_least) candidates.push_back({node, value});
  }
  return rank(candidates, same_place_nodes);
}

inline Ranking indexed(const PlaceIndex& index, const Signature& query, const std::vector<Views>& nodes,
                       int admissible, int same_place_nodes, const MatchConfig& config, double at_least = 0) {
  return index.find(
      query, {admissible, same_place_nodes, at_least}, config,
      [&nodes](const PlaceIndex::Entry& entry) -> const Signature& {
        return nodes[static_cast<std::size_t>(entry.node)][static_cast<std::size_t>(entry.view)];
      });
}

}  // namespace sailmap::testing
