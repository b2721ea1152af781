// Where a map that changes is highest.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "sailmap/ref/plane.hpp"

namespace sailmap {

// Keeps the maximum of every row: after a change only the rows that changed are searched again. Refers to
// the map, which must live as long.
template <class T>
class Highest {
 public:
  explicit Highest(const Plane<T>& map) : map_(&map), rows_(static_cast<std::size_t>(map.height())) {
    changed(0, map.height());
  }

  // Rows [first, end) of the map are different from before.
  void changed(int first, int end) {
    for (int y = first; y < end; ++y) {
      const auto row = row_of(y);
      T most = row.front();
      for (const T v : row) most = std::max(most, v);
      rows_[static_cast<std::size_t>(y)] = most;
    }
  }

  // (x, y) of the first of the largest samples in raster order.
  [[nodiscard]] std::pair<int, int> position() const {
    const auto most = std::max_element(rows_.begin(), rows_.end());
    const auto y = static_cast<int>(most - rows_.begin());
    const auto row = row_of(y);
    return {static_cast<int>(std::find(row.begin(), row.end(), *most) - row.begin()), y};
  }

 private:
  [[nodiscard]] std::span<const T> row_of(int y) const {
    const auto width = static_cast<std::size_t>(map_->width());
    return map_->samples().subspan(static_cast<std::size_t>(y) * width, width);
  }

  const Plane<T>* map_;
  std::vector<T> rows_;
};

}  // namespace sailmap
