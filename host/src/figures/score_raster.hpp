// A score matrix made small enough to be drawn.
#pragma once

#include "sailmap/ground_truth.hpp"
#include "sailmap/ref/plane.hpp"

namespace sailmap {

struct ScoreRaster {
  int step = 1;          // scores along each side that one cell stands for
  Plane<float> cells;    // the highest score of each block; NaN where none is admissible
  Plane<char> is_match;  // 1 where a ground-truth pair with an admissible score lies in the block
  double ceiling = 1;    // scores are clipped here for display
};

// At most `most` cells a side. The ceiling is the 99.5th percentile of the cells: a few identical images
// would otherwise make all others look alike.
ScoreRaster rasterise(const Plane<float>& scores, const GroundTruth& truth, int most);

}  // namespace sailmap
