// Precision and recall of place recognition (spec 12).
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "sailmap/ground_truth.hpp"
#include "sailmap/ref/plane.hpp"
#include "sailmap/similarity.hpp"

namespace sailmap {

inline constexpr float not_admissible = std::numeric_limits<float>::quiet_NaN();

// Each image against all earlier ones but the `exclude_recent` newest. Row = query, column = candidate; NaN
// where not admissible. Runs on all cores; the result does not depend on their number.
Plane<float> score_sequence(const std::vector<Signature>& images, int exclude_recent,
                            const MatchConfig& config);

// Two traverses: each query against all references.
Plane<float> score_traverses(const std::vector<Signature>& queries, const std::vector<Signature>& references,
                             const MatchConfig& config);

struct CurvePoint {
  double threshold = 0;  // detections: best candidate's score >= threshold
  double precision = 0;
  double recall = 0;
};

struct FixedThreshold {
  double threshold = 0;
  int detections = 0;  // best candidate's score above the threshold
  int right = 0;
  double precision = 0;  // 1 when there is no detection
  double recall = 0;
};

struct Evaluation {
  int queries = 0;                // with at least one admissible candidate
  int queries_with_match = 0;     // with at least one admissible true match
  std::vector<CurvePoint> curve;  // falling threshold, one point per distinct score
  double average_precision = 0;   // sum over the curve of (rise in recall) x precision
  double recall_at_100 = 0;       // highest recall of a point with precision 1
  double recall_at_95 = 0;        // highest recall of a point with precision >= 0.95
  double best_f1 = 0;
  double best_f1_threshold = 0;
  FixedThreshold fixed;
  // Part of the queries with a match that have one among their best 1, 5, 10 candidates.
  std::array<double, 3> recall_at{};
};

inline constexpr std::array<int, 3> recall_ranks = {1, 5, 10};

// `scores` and `truth` must have the same number of queries; throws Error otherwise, and when no query has an
// admissible true match.
Evaluation evaluate(const Plane<float>& scores, const GroundTruth& truth, double threshold);

}  // namespace sailmap
