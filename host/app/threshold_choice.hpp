// The threshold that gives a wanted precision, and what that rests on.
#pragma once

#include <vector>

#include "sailmap/evaluation.hpp"

namespace sailmap::app {

struct ThresholdChoice {
  double threshold = 0;  // detections: similarity above it
  double precision = 0;
  double recall = 0;
  int detections = 0;
  int right = 0;
  double precision_at_least = 0;  // with 95 % confidence, were the queries independent (Clopper-Pearson)
  int needed = 0;                 // detections, all right, that it takes to claim the wanted precision so
};

// Of the points of the curve with at least this precision (above 0, at most 1) the one of highest recall; the
// threshold lies between its score and the next lower one, with few digits. A precision of 1 cannot be
// claimed from any number of detections: `needed` is then that of 0.99. Throws Error, with the highest
// precision there is, when none is enough.
ThresholdChoice choose_threshold(const std::vector<CurvePoint>& curve, int queries_with_match,
                                 double precision);

}  // namespace sailmap::app
