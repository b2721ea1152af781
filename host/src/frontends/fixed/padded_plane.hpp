// Where the `fixed` front end keeps its samples between stages.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace sailmap::fixed {

// A width x height array with room around it: `margin` samples to the left and at least as many to the right
// of each row, `extra_rows` rows above and below. Filters read there what the border should be, and vector
// loops may run on beyond a row's end. Rows begin at a cache line.
template <class T>
class PaddedPlane {
 public:
  // Two of the widest vectors of 16-bit samples here.
  static constexpr int margin = 64;

  PaddedPlane() = default;
  explicit PaddedPlane(int extra_rows, T fill = T{}) : extra_rows_(extra_rows), fill_(fill) {}

  // Sets the size; another size fills all samples and the room around them. Memory is kept when it is enough.
  void resize(int width, int height) {
    if (width == width_ && height == height_) return;
    constexpr int line = cache_line / static_cast<int>(sizeof(T));
    width_ = width;
    height_ = height;
    stride_ = (width + line - 1) / line * line + 2 * margin;
    const std::ptrdiff_t rows = height + std::ptrdiff_t{2} * extra_rows_;
    memory_.assign(static_cast<std::size_t>(rows * stride_ + line), fill_);
    const auto address = reinterpret_cast<std::size_t>(memory_.data());  // NOLINT(*-reinterpret-cast)
    const std::size_t to_line = (cache_line - address % cache_line) % cache_line / sizeof(T);
    origin_ = static_cast<std::ptrdiff_t>(to_line) + margin + extra_rows_ * stride_;
  }

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  // y from -extra_rows; x = 0 of the row.
  [[nodiscard]] T* row(int y) { return memory_.data() + offset(y); }
  [[nodiscard]] const T* row(int y) const { return memory_.data() + offset(y); }
  // The row y, or the nearest one inside the plane.
  [[nodiscard]] const T* clamped_row(int y) const { return row(std::clamp(y, 0, height_ - 1)); }

 private:
  static constexpr int cache_line = 64;
  static_assert(margin * sizeof(T) % cache_line == 0);

  [[nodiscard]] std::ptrdiff_t offset(int y) const { return origin_ + y * stride_; }

  int extra_rows_ = 0;
  T fill_{};
  int width_ = 0;
  int height_ = 0;
  std::ptrdiff_t stride_ = 0;
  std::ptrdiff_t origin_ = 0;  // of row 0 in the memory
  std::vector<T> memory_;
};

// Edge replication, the border of every filter: `count` samples on each side of a row.
template <class T>
void replicate_edges(T* row, int width, int count) {
  std::fill(row - count, row, row[0]);
  std::fill(row + width, row + width + count, row[width - 1]);
}

}  // namespace sailmap::fixed
