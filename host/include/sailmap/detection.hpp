// The verdict on one image: has the robot been here, and why or why not (spec 11).
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "sailmap/similarity.hpp"

namespace sailmap {

enum class Reason {
  accepted,         // best similarity above the threshold: loop closure
  below_threshold,  // the best admissible node is not similar enough
  too_few_regions,  // similar enough, but on fewer matched regions than demanded
  ambiguous,        // a different place is nearly as similar
  excluded,         // no admissible node, all are among the exclude_recent newest
  no_nodes,         // the map is empty
  no_regions        // the image has no salient region (flat)
};

std::string_view name(Reason reason);
Reason reason_from_name(std::string_view name);  // throws Error

// The threshold that fits a method's scale: the paper's 20 for `paper`; for `paper_weighted`, whose
// similarities are smaller, one measured on real sequences (docs/decisions.md); for `context` 0.2,
// where it was right in at least 95 of 100 cases (docs/recognition.md).
double default_threshold(Method method);

struct DetectionConfig {
  double threshold = 20;  // Th_LCD, in the scale of the method `paper`; see default_threshold
  int min_matches = 1;    // least |MR| for a loop closure
  // A rival at another place at least this part of the best similarity makes the detection ambiguous; above
  // 1: never (the paper).
  double ambiguity_ratio = 2;
  int same_place_nodes = 5;  // rivals within so many nodes of the best are the same place
  // Among more nodes than these, the index of `paper` and `paper_weighted` searches for loop closures only,
  // which is quicker: an image that closes none then has no best node, and no rival is named that could not
  // have made a loop closure ambiguous.
  int ranked_nodes = 10000;
};

// No verdict depends on how similar a node is, or which it is, below this.
double least_that_matters(const DetectionConfig& config);

struct Candidate {
  int node = -1;
  double similarity = 0;
  bool operator==(const Candidate&) const = default;
};

// Of the admissible nodes the most similar, and the most similar of another place; the first in order on
// ties.
struct Ranking {
  Candidate best;       // node -1 when there is none
  Candidate runner_up;  // node -1 when there is none
  bool operator==(const Ranking&) const = default;
};

struct Detection {
  Reason reason = Reason::no_nodes;
  Candidate best;                    // node -1 when there is none
  Candidate runner_up;               // best of another place, node -1 when there is none
  std::vector<RegionMatch> matches;  // with the best node
  [[nodiscard]] bool accepted() const { return reason == Reason::accepted; }
};

// Best and runner-up among candidates in the order of their nodes.
Ranking rank(const std::vector<Candidate>& candidates, int same_place_nodes);

// `matches_with(node)` gives the matched regions; it is asked once, for the best node, if there is one.
Detection decide_ranked(const Ranking& ranking, const DetectionConfig& config,
                        const std::function<std::vector<RegionMatch>(int node)>& matches_with);

// Ranks the candidates and decides.
Detection decide(const std::vector<Candidate>& candidates, const DetectionConfig& config,
                 const std::function<std::vector<RegionMatch>(int node)>& matches_with);

}  // namespace sailmap
