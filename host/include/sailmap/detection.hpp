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
// similarities are smaller, one measured on real sequences (docs/decisions.md); for `context` 0.3,
// where it was right in at least 95 of 100 cases (docs/recognition.md).
double default_threshold(Method method);

struct DetectionConfig {
  double threshold = 20;  // Th_LCD, in the scale of the method `paper`; see default_threshold
  int min_matches = 1;    // least |MR| for a loop closure
  // A rival at another place at least this part of the best similarity makes the detection ambiguous; above
  // 1: never (the paper).
  double ambiguity_ratio = 2;
  int same_place_nodes = 5;  // rivals within so many nodes of the best are the same place
};

struct Candidate {
  int node = -1;
  double similarity = 0;
};

struct Detection {
  Reason reason = Reason::no_nodes;
  Candidate best;                    // node -1 when there is none
  Candidate runner_up;               // best of another place, node -1 when there is none
  std::vector<RegionMatch> matches;  // with the best node
  [[nodiscard]] bool accepted() const { return reason == Reason::accepted; }
};

// Picks best and runner-up among admissible nodes (the first in order on ties) and decides.
// `matches_with(node)` gives the matched regions; it is asked once, for the best node.
Detection decide(const std::vector<Candidate>& candidates, const DetectionConfig& config,
                 const std::function<std::vector<RegionMatch>(int node)>& matches_with);

}  // namespace sailmap
