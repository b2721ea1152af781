#include "graph.hpp"

#include <algorithm>
#include <cmath>

#include "figures/graph_drawing.hpp"
#include "sailmap/error.hpp"
#include "subject.hpp"

namespace sailmap::report {
namespace {

constexpr int most_for_stress = 600;  // stress majorisation takes quadratic time and memory

}  // namespace

std::vector<double> lay_out(int nodes, const std::vector<Edge>& edges) {
  GraphDrawing graph;
  for (int id = 0; id < nodes; ++id) graph.add_node(id, {});
  for (const Edge& edge : edges) graph.add_edge(edge.from, edge.to, {});
  std::vector<double> out(2 * static_cast<std::size_t>(nodes));
  for (const auto& [id, at] : graph.positions(nodes <= most_for_stress ? "neato" : "sfdp")) {
    out[2 * static_cast<std::size_t>(id)] = at.x;
    out[2 * static_cast<std::size_t>(id) + 1] = at.y;
  }
  return out;
}

std::vector<double> node_positions(const TopologicalMap& map, const std::vector<Pose>& positions) {
  std::vector<double> out;
  for (const Node& node : map.nodes()) {
    const Pose& pose = positions.at(static_cast<std::size_t>(node.views.front().image));
    out.push_back(pose.x);
    out.push_back(pose.y);
  }
  return out;
}

nlohmann::ordered_json graph_of(const TopologicalMap& map) {
  nlohmann::ordered_json first = nlohmann::ordered_json::array();
  nlohmann::ordered_json views = nlohmann::ordered_json::array();
  for (const Node& node : map.nodes()) {
    first.push_back(node.views.front().image);
    views.push_back(node.views.size());
  }
  nlohmann::ordered_json paths = nlohmann::ordered_json::array();
  for (const Edge& edge : map.edges()) {
    if (edge.kind != EdgeKind::path) continue;
    paths.push_back(edge.from);
    paths.push_back(edge.to);
  }
  nlohmann::ordered_json out = {{"nodes", map.nodes().size()}, {"images", std::move(first)}};
  if (map.config().sparse) out["views"] = std::move(views);
  out["paths"] = std::move(paths);
  out["active"] = map.active();
  return out;
}

nlohmann::ordered_json rounded_positions(const std::vector<double>& positions) {
  double span = 0;
  for (const std::size_t axis : {0U, 1U}) {
    double least = 0;
    double most = 0;
    for (std::size_t i = axis; i < positions.size(); i += 2) {
      least = i == axis ? positions[i] : std::min(least, positions[i]);
      most = i == axis ? positions[i] : std::max(most, positions[i]);
    }
    span = std::max(span, most - least);
  }
  const double step = span > 0 ? std::pow(10, std::floor(std::log10(span / 10000))) : 1;
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const double position : positions) out.push_back(shortened(std::round(position / step) * step));
  return out;
}

}  // namespace sailmap::report
