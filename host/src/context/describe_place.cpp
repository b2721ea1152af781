#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "area_means.hpp"
#include "sailmap/place_descriptor.hpp"
#include "salient_peaks.hpp"

namespace sailmap {
namespace {

using context::AreaMeans;
using context::CellEdges;

// The context of a region, in parts of the image: what 10 of 32 columns and 10 of 24 rows span.
constexpr double context_width = 10.0 / 32;
constexpr double context_height = 10.0 / 24;
constexpr int neighbourhood = 2;  // cells of the layout to each side

// The mean of the cells around one.
float mean_around(const std::vector<float>& cells, int column, int row) {
  float sum = 0;
  int count = 0;
  for (int y = std::max(0, row - neighbourhood); y <= std::min(Layout::rows - 1, row + neighbourhood); ++y) {
    for (int x = std::max(0, column - neighbourhood);
         x <= std::min(Layout::columns - 1, column + neighbourhood); ++x) {
      sum += cells[static_cast<std::size_t>(y * Layout::columns + x)];
      ++count;
    }
  }
  return sum / static_cast<float>(count);
}

Layout layout_of(const std::vector<AreaMeans>& maps) {
  const int width = maps.front().width();
  const int height = maps.front().height();
  const CellEdges columns(0, static_cast<double>(width) / Layout::columns, Layout::columns, width);
  const CellEdges rows(0, static_cast<double>(height) / Layout::rows, Layout::rows, height);
  Layout out;
  std::vector<float> cells;
  for (std::size_t map = 0; map < maps.size(); ++map) {
    root_means(maps[map], columns, rows, cells);
    for (int y = 0; y < Layout::rows; ++y) {
      const auto bit = static_cast<std::size_t>(y) * feature_count + map;
      for (int x = 0; x < Layout::columns; ++x) {
        if (cells[static_cast<std::size_t>(y * Layout::columns + x)] > mean_around(cells, x, y)) {
          out.words[static_cast<std::size_t>(x)][bit / 64] |= std::uint64_t{1} << (bit % 64);
        }
      }
    }
  }
  return out;
}

std::uint16_t part(int sample, int length) {
  return static_cast<std::uint16_t>(std::lround((sample + 0.5) / length * 65535));
}

ContextRegion region_at(const Peak& peak, const std::vector<AreaMeans>& maps) {
  constexpr int side = ContextRegion::side;
  const int width = maps.front().width();
  const int height = maps.front().height();
  ContextRegion out;
  out.x = part(peak.x, width);
  out.y = part(peak.y, height);
  const CellEdges columns(peak.x + 0.5 - width * context_width / 2, width * context_width / side, side,
                          width);
  const CellEdges rows(peak.y + 0.5 - height * context_height / 2, height * context_height / side, side,
                       height);
  std::vector<float> cells;
  for (std::size_t map = 0; map < maps.size(); ++map) {
    root_means(maps[map], columns, rows, cells);
    const auto [least, most] = std::minmax_element(cells.begin(), cells.end());
    // Rounding alone makes no structure.
    if (!(*most > *least * 1.001F)) continue;
    out.varied = static_cast<std::uint16_t>(out.varied | (1U << map));
    const float mean = std::accumulate(cells.begin(), cells.end(), 0.0F) / static_cast<float>(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i] > mean) out.bits[map] |= std::uint64_t{1} << i;
    }
  }
  return out;
}

}  // namespace

PlaceDescriptor describe_place(const Maps& maps) {
  // Kept from image to image: to get one and a half megabytes anew costs a fifth of the time.
  thread_local std::vector<AreaMeans> means(feature_count);
  for (std::size_t i = 0; i < feature_count; ++i) means[i].set(maps.features[i]);
  PlaceDescriptor out;
  out.layout = layout_of(means);
  for (const Peak& peak : context::salient_peaks(maps.saliency, PlaceDescriptor::max_regions)) {
    out.regions.push_back(region_at(peak, means));
  }
  return out;
}

}  // namespace sailmap
