#include "sailmap/maps.hpp"

#include <type_traits>

namespace sailmap {

int Map::width() const {
  return std::visit([](const auto& plane) { return plane.width(); }, samples);
}

int Map::height() const {
  return std::visit([](const auto& plane) { return plane.height(); }, samples);
}

double Map::at(int x, int y) const {
  return lsb * std::visit([x, y](const auto& plane) { return static_cast<double>(plane(x, y)); }, samples);
}

double Map::mean(const Box& box) const {
  const double sum = std::visit(
      [&box](const auto& plane) {
        // Sums of integers are exact in either type.
        using Sample = std::remove_cvref_t<decltype(plane.samples()[0])>;
        std::conditional_t<std::is_integral_v<Sample>, std::uint64_t, double> total = 0;
        for (int y = box.y0; y < box.y1; ++y) {
          for (int x = box.x0; x < box.x1; ++x) total += plane(x, y);
        }
        return static_cast<double>(total);
      },
      samples);
  return lsb * sum / box.area();
}

Plane<double> Map::values() const {
  Plane<double> out(width(), height());
  std::visit(
      [this, &out](const auto& plane) {
        const auto in = plane.samples();
        const auto to = out.samples();
        for (std::size_t i = 0; i < in.size(); ++i) to[i] = lsb * static_cast<double>(in[i]);
      },
      samples);
  return out;
}

}  // namespace sailmap
