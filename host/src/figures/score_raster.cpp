#include "score_raster.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "sailmap/error.hpp"

namespace sailmap {
namespace {

double high_percentile(const Plane<float>& cells) {
  std::vector<float> finite;
  std::copy_if(cells.samples().begin(), cells.samples().end(), std::back_inserter(finite),
               [](float v) { return !std::isnan(v); });
  if (finite.empty()) return 1;
  const auto rank = static_cast<std::ptrdiff_t>(ceiling_part * static_cast<double>(finite.size() - 1));
  std::nth_element(finite.begin(), finite.begin() + rank, finite.end());
  auto value = static_cast<double>(finite[static_cast<std::size_t>(rank)]);
  // With hardly any similarity at all the percentile is 0; then the scale must reach the exceptions.
  if (!(value > 0)) value = static_cast<double>(*std::max_element(finite.begin(), finite.end()));
  return value > 0 ? value : 1;
}

void check(const Plane<float>& scores, const GroundTruth& truth) {
  if (scores.empty()) throw Error("evaluation plot: there are no scores");
  if (static_cast<int>(truth.matches.size()) != scores.height()) {
    throw Error(fmt::format("evaluation plot: ground truth is for {} queries, but there are {}",
                            truth.matches.size(), scores.height()));
  }
  for (std::size_t q = 0; q < truth.matches.size(); ++q) {
    for (const int candidate : truth.matches[q]) {
      if (candidate >= 0 && candidate < scores.width()) continue;
      throw Error(fmt::format("evaluation plot: query {} matches candidate {}, but there are {}", q,
                              candidate, scores.width()));
    }
  }
}

// Cell of each of `count` rows or columns.
std::vector<int> cells_of(int count, int cells) {
  std::vector<int> out(static_cast<std::size_t>(count));
  for (int cell = 0; cell < cells; ++cell) {
    const auto start = [&](int c) { return static_cast<std::ptrdiff_t>(c) * count / cells; };
    std::fill(out.begin() + start(cell), out.begin() + start(cell + 1), cell);
  }
  return out;
}

// The edges between rows of cells that differ, neighbours joined; `transposed` for those between columns.
void add_edges(const Plane<char>& mask, bool transposed, std::vector<Segment>& out) {
  const int width = transposed ? mask.height() : mask.width();
  const int height = transposed ? mask.width() : mask.height();
  const auto filled = [&](int x, int y) {
    return y >= 0 && y < height && (transposed ? mask(y, x) : mask(x, y)) != 0;
  };
  for (int y = 0; y <= height; ++y) {
    int start = -1;
    for (int x = 0; x <= width; ++x) {
      const bool edge = x < width && filled(x, y - 1) != filled(x, y);
      if (edge && start < 0) start = x;
      if (edge || start < 0) continue;
      const Segment run{static_cast<double>(start), static_cast<double>(y), static_cast<double>(x),
                        static_cast<double>(y)};
      out.push_back(transposed ? Segment{run.y0, run.x0, run.y1, run.x1} : run);
      start = -1;
    }
  }
}

Plane<char> halved(const Plane<char>& mask) {
  Plane<char> out((mask.width() + 1) / 2, (mask.height() + 1) / 2, 0);
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (mask(x, y) != 0) out(x / 2, y / 2) = 1;
    }
  }
  return out;
}

}  // namespace

ScoreRaster rasterise(const Plane<float>& scores, const GroundTruth& truth, int most) {
  check(scores, truth);
  ScoreRaster out;
  const int width = std::min(scores.width(), most);
  const int height = std::min(scores.height(), most);
  const std::vector<int> column = cells_of(scores.width(), width);
  const std::vector<int> row = cells_of(scores.height(), height);
  out.cells.reset(width, height, std::numeric_limits<float>::quiet_NaN());
  out.is_match.reset(width, height, 0);
  for (int y = 0; y < scores.height(); ++y) {
    const int cell_y = row[static_cast<std::size_t>(y)];
    for (int x = 0; x < scores.width(); ++x) {
      const float score = scores(x, y);
      float& cell = out.cells(column[static_cast<std::size_t>(x)], cell_y);
      if (!std::isnan(score) && !(cell >= score)) cell = score;
    }
    for (const int candidate : truth.matches[static_cast<std::size_t>(y)]) {
      if (std::isnan(scores(candidate, y))) continue;
      out.is_match(column[static_cast<std::size_t>(candidate)], cell_y) = 1;
    }
  }
  out.ceiling = high_percentile(out.cells);
  return out;
}

Plane<float> enlarged(const Plane<float>& cells, int least) {
  const int side = std::max(cells.width(), cells.height());
  const int times = std::max(1, (least + side - 1) / side);
  Plane<float> out(cells.width() * times, cells.height() * times);
  for (int y = 0; y < out.height(); ++y) {
    for (int x = 0; x < out.width(); ++x) out(x, y) = cells(x / times, y / times);
  }
  return out;
}

Plane<char> widened(const Plane<char>& is_match, int by) {
  Plane<char> out = is_match;
  if (by <= 0) return out;
  cv::Mat cells(out.height(), out.width(), CV_8UC1, out.samples().data());
  cv::dilate(cells, cells, cv::Mat::ones(2 * by + 1, 2 * by + 1, CV_8UC1));
  return out;
}

std::vector<Segment> outline(const Plane<char>& is_match, std::size_t most) {
  Plane<char> mask = is_match;
  double side = 1;
  while (true) {
    std::vector<Segment> segments;
    add_edges(mask, false, segments);
    add_edges(mask, true, segments);
    if (segments.size() <= most || (mask.width() == 1 && mask.height() == 1)) {
      const auto on_matrix = [side](double v, int end) {
        return std::min(v * side, static_cast<double>(end));
      };
      for (Segment& s : segments) {
        s = {on_matrix(s.x0, is_match.width()), on_matrix(s.y0, is_match.height()),
             on_matrix(s.x1, is_match.width()), on_matrix(s.y1, is_match.height())};
      }
      return segments;
    }
    mask = halved(mask);
    side *= 2;
  }
}

}  // namespace sailmap
