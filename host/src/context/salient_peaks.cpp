#include "salient_peaks.hpp"

#include <algorithm>
#include <cstddef>

namespace sailmap::context {
namespace {

constexpr double stop_ratio = 1.0 / 16;

// A copy of the map that knows the first highest sample of each row.
class Field {
 public:
  explicit Field(const Map& map) : values_(map.values()) {
    for (int y = 0; y < values_.height(); ++y) highest_.push_back(highest_in(y));
  }

  // The first of the highest in raster order.
  [[nodiscard]] Peak highest() const {
    Peak best{highest_[0], 0, values_(highest_[0], 0)};
    for (int y = 1; y < values_.height(); ++y) {
      const int x = highest_[static_cast<std::size_t>(y)];
      if (values_(x, y) > best.saliency) best = {x, y, values_(x, y)};
    }
    return best;
  }

  void inhibit(const Peak& peak) {
    const int across = std::max(1, values_.width() / 40);
    const int down = std::max(1, values_.height() / 30);
    const int x0 = std::max(0, peak.x - across);
    const int x1 = std::min(values_.width() - 1, peak.x + across);
    for (int y = std::max(0, peak.y - down); y <= std::min(values_.height() - 1, peak.y + down); ++y) {
      for (int x = x0; x <= x1; ++x) values_(x, y) = 0;
      highest_[static_cast<std::size_t>(y)] = highest_in(y);
    }
  }

 private:
  [[nodiscard]] int highest_in(int y) const {
    const auto samples = values_.samples();
    const auto begin = samples.begin() + static_cast<std::ptrdiff_t>(y) * values_.width();
    return static_cast<int>(std::max_element(begin, begin + values_.width()) - begin);
  }

  Plane<double> values_;
  std::vector<int> highest_;  // of each row, its x
};

}  // namespace

std::vector<Peak> salient_peaks(const Map& saliency, int max_regions) {
  Field field(saliency);
  std::vector<Peak> peaks;
  while (static_cast<int>(peaks.size()) < max_regions) {
    const Peak peak = field.highest();
    if (peak.saliency <= 0) break;
    if (!peaks.empty() && peak.saliency <= peaks.front().saliency * stop_ratio) break;
    peaks.push_back(peak);
    field.inhibit(peak);
  }
  return peaks;
}

}  // namespace sailmap::context
