#include "matrix.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base64.hpp"
#include "figures/score_raster.hpp"
#include "sailmap/context.hpp"
#include "sailmap/evaluation.hpp"

namespace sailmap::report {
namespace {

// At most `most` of 0 .. count - 1, evenly spread.
std::vector<int> spread(std::size_t count, int most) {
  const std::size_t taken = std::min(count, static_cast<std::size_t>(most));
  std::vector<int> out;
  for (std::size_t k = 0; k < taken; ++k) out.push_back(static_cast<int>(k * count / taken));
  return out;
}

// The most similar of a node's views, as the map compares.
float similarity(const Signature& image, const Node& node, const MatchConfig& config) {
  double best = 0;
  for (const View& view : node.views) {
    if (view.signature.width != image.width || view.signature.height != image.height) continue;
    best = std::max(best, match(image, view.signature, config).similarity);
  }
  return static_cast<float>(best);
}

std::vector<float> similarities(const Signature& image, const std::vector<const Node*>& nodes,
                                const MatchConfig& config) {
  std::vector<float> out;
  if (config.method != Method::context) {
    for (const Node* node : nodes) out.push_back(similarity(image, *node, config));
    return out;
  }
  std::vector<const PlaceDescriptor*> places;
  for (const Node* node : nodes) places.push_back(&node->views.front().signature.place.get());
  return score_contexts(image.place, places);
}

// Of each thinned index, the image it begins with.
std::vector<int> starts(const std::vector<int>& images, int cells) {
  std::vector<int> out;
  for (int c = 0; c < cells; ++c) {
    out.push_back(images[static_cast<std::size_t>(c) * images.size() / static_cast<std::size_t>(cells)]);
  }
  return out;
}

// Ground truth between images as one between rows and columns; of a thinned matrix the sampled ones alone.
GroundTruth truth_of_sample(const Similarities& s, const GroundTruth& truth) {
  GroundTruth out;
  out.matches.resize(s.rows.size());
  if (truth.matches.empty()) return out;
  std::map<int, int> column_of;
  for (std::size_t c = 0; c < s.columns.size(); ++c) column_of[s.columns[c]] = static_cast<int>(c);
  for (std::size_t r = 0; r < s.rows.size(); ++r) {
    for (const int candidate : truth.matches[static_cast<std::size_t>(s.rows[r])]) {
      const auto found = column_of.find(candidate);
      if (found != column_of.end()) out.matches[r].push_back(found->second);
    }
  }
  return out;
}

}  // namespace

std::vector<int> matrix_rows(const TopologicalMap& map) {
  return spread(static_cast<std::size_t>(map.images()), matrix_side);
}

Similarities compare_images(const TopologicalMap& map,
                            const std::function<std::optional<Signature>(int image)>& signature_of) {
  Similarities out;
  out.rows = matrix_rows(map);
  std::vector<const Node*> nodes;
  for (const int id : spread(map.nodes().size(), matrix_columns)) {
    nodes.push_back(&map.nodes()[static_cast<std::size_t>(id)]);
    out.columns.push_back(nodes.back()->views.front().image);
  }
  out.scores.reset(static_cast<int>(out.columns.size()), static_cast<int>(out.rows.size()), not_admissible);
  std::vector<std::optional<Signature>> images;
  for (const int row : out.rows) images.push_back(signature_of(row));
  out.unknown = static_cast<int>(std::ranges::count_if(images, [](const auto& image) { return !image; }));
  tbb::parallel_for(std::size_t{0}, images.size(), [&](std::size_t r) {
    if (!images[r]) return;
    const int last = first_not_admissible(map, out.rows[r]);
    std::vector<const Node*> admissible;
    for (const Node* node : nodes) {
      if (node->views.front().image < last) admissible.push_back(node);
    }
    const std::vector<float> row = similarities(*images[r], admissible, map.config().match);
    for (std::size_t c = 0; c < row.size(); ++c) {
      out.scores(static_cast<int>(c), static_cast<int>(r)) = row[c];
    }
  });
  return out;
}

nlohmann::ordered_json matrix_of(const Similarities& s, const GroundTruth& truth) {
  if (s.scores.empty()) return nullptr;
  const ScoreRaster raster = rasterise(s.scores, truth_of_sample(s, truth), matrix_side);
  std::vector<std::uint8_t> cells;
  for (const float value : raster.cells.samples()) {
    const double part = std::clamp(static_cast<double>(value) / raster.ceiling, 0.0, 1.0);
    cells.push_back(std::isnan(value) ? 255 : static_cast<std::uint8_t>(std::lround(254 * part)));
  }
  nlohmann::ordered_json marks = nlohmann::ordered_json::array();
  for (int y = 0; y < raster.is_match.height(); ++y) {
    for (int x = 0; x < raster.is_match.width(); ++x) {
      if (raster.is_match(x, y) == 0) continue;
      marks.push_back(x);
      marks.push_back(y);
    }
  }
  return {{"rows", starts(s.rows, raster.cells.height())},
          {"columns", starts(s.columns, raster.cells.width())},
          {"cells", base64(cells)},
          {"ceiling", shortened(raster.ceiling)},
          {"truth", std::move(marks)}};
}

}  // namespace sailmap::report
