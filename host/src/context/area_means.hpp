// Means of a map over rectangles with real corners.
#pragma once

#include <vector>

#include "sailmap/maps.hpp"

namespace sailmap::context {

// Summed-area table of one map, in the map's own unit; sums between samples are interpolated, so that a
// sample counts with the part of it that a rectangle covers.
class AreaMeans {
 public:
  explicit AreaMeans(const Map& map);
  // Sum over [0, x) x [0, y), 0 <= x <= width, 0 <= y <= height.
  [[nodiscard]] double sum(double x, double y) const;
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  int width_;
  int height_;
  std::vector<double> table_;  // (width + 1) x (height + 1)
};

// Edges of `count` cells of equal size side by side, from `first` on; cut at 0 and `length`.
struct CellEdges {
  CellEdges(double first, double cell, int count, double length);
  std::vector<double> at;   // count + 1, rising
  std::vector<int> source;  // of each cell: itself, or the nearest one that lies inside
};

// Square roots of the means of all cells, row by row. The root lets weak structure beside strong count.
void root_means(const AreaMeans& map, const CellEdges& columns, const CellEdges& rows,
                std::vector<float>& out);

}  // namespace sailmap::context
