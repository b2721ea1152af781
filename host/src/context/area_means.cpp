#include "area_means.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sailmap::context {

Position::Position(double coordinate, int length)
    : sample(static_cast<std::size_t>(std::min(static_cast<int>(coordinate), length - 1))),
      part(coordinate - static_cast<double>(sample)) {}

void AreaMeans::set(const Map& map) {
  if (width_ != map.width() || height_ != map.height()) {
    width_ = map.width();
    height_ = map.height();
    // The first row and column stay 0.
    table_.assign(static_cast<std::size_t>(width_ + 1) * static_cast<std::size_t>(height_ + 1), 0.0);
  }
  std::visit(
      [this](const auto& plane) {
        const auto in = plane.samples();
        const auto stride = static_cast<std::size_t>(width_) + 1;
        for (std::size_t y = 0; y < static_cast<std::size_t>(height_); ++y) {
          double row = 0;
          for (std::size_t x = 0; x + 1 < stride; ++x) {
            row += static_cast<double>(in[y * (stride - 1) + x]);
            table_[(y + 1) * stride + x + 1] = table_[y * stride + x + 1] + row;
          }
        }
      },
      map.samples);
}

double AreaMeans::sum(double x, double y) const { return sum(Position(x, width_), Position(y, height_)); }

CellEdges::CellEdges(double first, double cell, int count, int length) {
  for (int i = 0; i <= count; ++i) {
    at.push_back(std::clamp(first + i * cell, 0.0, static_cast<double>(length)));
    positions.emplace_back(at.back(), length);
  }
  // A sliver at the border says little of what its cell would hold.
  const auto inside = [&](int i) {
    return at[static_cast<std::size_t>(i) + 1] - at[static_cast<std::size_t>(i)] >= cell / 4;
  };
  for (int i = 0; i < count; ++i) {
    int nearest = i;
    for (int away = 1; away < count && !inside(nearest); ++away) {
      if (i + away < count && inside(i + away)) nearest = i + away;
      if (i - away >= 0 && inside(i - away)) nearest = i - away;
    }
    source.push_back(nearest);
  }
}

void root_means(const AreaMeans& map, const CellEdges& columns, const CellEdges& rows,
                std::vector<float>& out) {
  const std::size_t across = columns.at.size();
  const std::size_t down = rows.at.size();
  std::vector<double> sums(across * down);
  for (std::size_t y = 0; y < down; ++y) {
    for (std::size_t x = 0; x < across; ++x)
      sums[y * across + x] = map.sum(columns.positions[x], rows.positions[y]);
  }
  out.clear();
  for (const int row : rows.source) {
    const auto y = static_cast<std::size_t>(row);
    for (const int column : columns.source) {
      const auto x = static_cast<std::size_t>(column);
      const double total = sums[(y + 1) * across + x + 1] - sums[(y + 1) * across + x] -
                           sums[y * across + x + 1] + sums[y * across + x];
      const double area = (rows.at[y + 1] - rows.at[y]) * (columns.at[x + 1] - columns.at[x]);
      // Differences of sums may fall a rounding below 0.
      out.push_back(static_cast<float>(area > 0 ? std::sqrt(std::max(0.0, total) / area) : 0));
    }
  }
}

}  // namespace sailmap::context
