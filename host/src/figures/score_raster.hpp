// A score matrix and its ground truth made small enough to be drawn. Rows are queries, columns candidates.
#pragma once

#include <vector>

#include "sailmap/ground_truth.hpp"
#include "sailmap/ref/plane.hpp"

namespace sailmap {

// Cell (x, y) of w x h stands for the scores of columns [x W / w, (x + 1) W / w) and rows [y H / h, (y + 1) H
// / h), rounded down, of a W x H matrix.
struct ScoreRaster {
  Plane<float> cells;    // the highest score of each block; NaN where none is admissible
  Plane<char> is_match;  // 1 where a ground-truth pair with an admissible score lies in the block
  double ceiling = 1;    // scores are clipped here for display: the 99.5th percentile of the cells, above 0
};

inline constexpr double ceiling_part = 0.995;

// At most `most` cells a side. A few identical images would make all others look alike, hence the ceiling.
// Throws Error when the matrix is empty or the ground truth is not of it.
ScoreRaster rasterise(const Plane<float>& scores, const GroundTruth& truth, int most);

// Each cell repeated so that the longer side is at least `least` cells: viewers blur enlarged pictures.
Plane<float> enlarged(const Plane<float>& cells, int least);

// From (x0, y0) to (x1, y1), on the lines between cells; (0, 0) is the upper left corner of the matrix.
struct Segment {
  double x0 = 0;
  double y0 = 0;
  double x1 = 0;
  double y1 = 0;
  bool operator==(const Segment&) const = default;
};

// The cells that are 1, and those up to `by` cells to each side of them: an outline round these leaves them
// to be seen.
Plane<char> widened(const Plane<char>& is_match, int by);

// The outline of all cells that are 1. With more than `most` segments the cells are joined two by two until
// there are fewer; coordinates stay those of `is_match`.
std::vector<Segment> outline(const Plane<char>& is_match, std::size_t most);

}  // namespace sailmap
