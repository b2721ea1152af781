// Two small types that hold images: Plane (owns its samples) and ImageView (borrows 8-bit colour pixels).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sailmap {

// A width x height array of samples in raster order. Indices: x right, y down, both from 0.
template <class T>
class Plane {
 public:
  Plane() = default;
  Plane(int width, int height, T fill = T{}) { reset(width, height, fill); }

  // Sets the size and every sample; memory is kept when the new size fits.
  void reset(int width, int height, T fill = T{}) {
    width_ = width;
    height_ = height;
    samples_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill);
  }

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] bool empty() const { return samples_.empty(); }

  T& operator()(int x, int y) { return samples_[index(x, y)]; }
  const T& operator()(int x, int y) const { return samples_[index(x, y)]; }

  // The sample at (x, y), or the nearest one inside the plane: edge replication, the border of every filter.
  [[nodiscard]] const T& clamped(int x, int y) const {
    return (*this)(std::clamp(x, 0, width_ - 1), std::clamp(y, 0, height_ - 1));
  }

  [[nodiscard]] std::span<T> samples() { return samples_; }
  [[nodiscard]] std::span<const T> samples() const { return samples_; }

  bool operator==(const Plane&) const = default;

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<T> samples_;
};

enum class ChannelOrder { rgb, bgr };

// Borrowed 8-bit colour image, three interleaved bytes a pixel, rows `stride` bytes apart.
struct ImageView {
  int width = 0;
  int height = 0;
  const std::uint8_t* data = nullptr;
  std::ptrdiff_t stride = 0;
  ChannelOrder order = ChannelOrder::bgr;

  struct Rgb {
    int r, g, b;
  };
  [[nodiscard]] Rgb at(int x, int y) const {
    const std::uint8_t* p =
        data + static_cast<std::ptrdiff_t>(y) * stride + static_cast<std::ptrdiff_t>(x) * 3;
    return order == ChannelOrder::rgb ? Rgb{p[0], p[1], p[2]} : Rgb{p[2], p[1], p[0]};
  }
};

}  // namespace sailmap
