#include "score_raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sailmap {
namespace {

double high_percentile(const Plane<float>& cells) {
  std::vector<float> finite;
  std::copy_if(cells.samples().begin(), cells.samples().end(), std::back_inserter(finite),
               [](float v) { return !std::isnan(v); });
  if (finite.empty()) return 1;
  const auto rank = static_cast<std::ptrdiff_t>(0.995 * static_cast<double>(finite.size() - 1));
  std::nth_element(finite.begin(), finite.begin() + rank, finite.end());
  const double value = static_cast<double>(finite[static_cast<std::size_t>(rank)]);
  return value > 0 ? value : 1;
}

}  // namespace

ScoreRaster rasterise(const Plane<float>& scores, const GroundTruth& truth, int most) {
  ScoreRaster out;
  const int side = std::max(scores.width(), scores.height());
  out.step = (side + most - 1) / most;
  const int width = (scores.width() + out.step - 1) / out.step;
  const int height = (scores.height() + out.step - 1) / out.step;
  out.cells.reset(width, height, std::numeric_limits<float>::quiet_NaN());
  out.is_match.reset(width, height, 0);
  for (int y = 0; y < scores.height(); ++y) {
    for (int x = 0; x < scores.width(); ++x) {
      const float score = scores(x, y);
      float& cell = out.cells(x / out.step, y / out.step);
      if (!std::isnan(score) && !(cell >= score)) cell = score;
    }
    for (const int candidate : truth.matches[static_cast<std::size_t>(y)]) {
      if (!std::isnan(scores(candidate, y))) out.is_match(candidate / out.step, y / out.step) = 1;
    }
  }
  out.ceiling = high_percentile(out.cells);
  return out;
}

}  // namespace sailmap
