// Means of a map over rectangles with real corners.
#pragma once

#include <cstddef>
#include <vector>

#include "sailmap/maps.hpp"

namespace sailmap::context {

// A coordinate from 0 to `length`: `part`, 0 .. 1, of sample number `sample`, which is below `length`.
struct Position {
  Position(double coordinate, int length);
  std::size_t sample;
  double part;
};

// Summed-area table of one map, in the map's own unit; sums between samples are interpolated, so that a
// sample counts with the part of it that a rectangle covers.
class AreaMeans {
 public:
  AreaMeans() = default;
  explicit AreaMeans(const Map& map) { set(map); }
  // Of another map, in the memory of the last one where that is enough.
  void set(const Map& map);
  // Sum over [0, x) x [0, y), 0 <= x <= width, 0 <= y <= height.
  [[nodiscard]] double sum(double x, double y) const;
  // The same at a sample and the part of it that counts, in both directions: Position below.
  [[nodiscard]] double sum(const Position& x, const Position& y) const {
    const auto stride = static_cast<std::size_t>(width_) + 1;
    const double* corner = &table_[y.sample * stride + x.sample];
    const double above = corner[0] + x.part * (corner[1] - corner[0]);
    const double below = corner[stride] + x.part * (corner[stride + 1] - corner[stride]);
    return above + y.part * (below - above);
  }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<double> table_;  // (width + 1) x (height + 1)
};

// Edges of `count` cells of equal size side by side, from `first` on; cut at 0 and `length`.
struct CellEdges {
  CellEdges(double first, double cell, int count, int length);
  std::vector<double> at;           // count + 1, rising
  std::vector<Position> positions;  // the same
  std::vector<int> source;          // of each cell: itself, or the nearest one that lies inside
};

// Square roots of the means of all cells, row by row. The root lets weak structure beside strong count.
void root_means(const AreaMeans& map, const CellEdges& columns, const CellEdges& rows,
                std::vector<float>& out);

}  // namespace sailmap::context
