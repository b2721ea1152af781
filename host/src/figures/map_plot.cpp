// A topological map as a graph, laid out by graphviz.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "drawing.hpp"
#include "graph_drawing.hpp"
#include "sailmap/error.hpp"
#include "sailmap/figures.hpp"
#include "sailmap/file.hpp"

namespace sailmap {
namespace {

constexpr std::size_t most_numbered = 120;    // nodes that have their number inside
constexpr std::size_t outside_numbers = 40;   // of larger maps: so many nodes have their number beside them
constexpr std::size_t most_for_stress = 600;  // stress majorisation takes quadratic time and memory
constexpr double scale_top = 4;               // times the threshold where the colours of loops end
constexpr int scale_steps = 6;

// The highest similarity of an accepted detection that joined two nodes, by the nodes in rising order.
using Strengths = std::map<std::pair<int, int>, double>;

Strengths loop_strengths(const TopologicalMap& map) {
  Strengths out;
  int active = -1;
  for (const Update& update : map.history()) {
    if (update.detection.accepted()) {
      double& best = out[std::minmax(active, update.node)];
      best = std::max(best, update.detection.best.similarity);
    }
    active = update.node;
  }
  return out;
}

// From orange at part 0 to dark red at 1.
std::string loop_colour(double part) {
  const double p = std::clamp(part, 0.0, 1.0);
  const auto mix = [p](int weak, int strong) { return static_cast<int>(weak + p * (strong - weak)); };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(253, 139), mix(174, 0), mix(97, 20));
}

// Sizes in inches and points: the more nodes, the smaller.
void set_style(GraphDrawing& graph, std::size_t nodes) {
  const bool few = nodes <= 40;
  const bool numbered = nodes <= most_numbered;
  const bool many = nodes > 400;
  const char* side = few ? "0.34" : numbered ? "0.26" : !many ? "0.12" : nodes <= 1500 ? "0.05" : "0.012";
  // Among many nodes loops would be hidden beneath them.
  graph.set_default(GraphDrawing::Part::graph, {{"outputorder", many ? "nodesfirst" : "edgesfirst"}});
  graph.set_default(GraphDrawing::Part::node, {{"shape", "circle"},
                                               {"style", "filled"},
                                               {"fillcolor", "#deebf7"},
                                               {"color", "#4292c6"},
                                               {"penwidth", many ? "0.4" : "1"},
                                               {"fixedsize", "true"},
                                               {"width", side},
                                               {"label", ""},
                                               {"xlabel", ""},
                                               {"fontname", "DejaVu Sans"},
                                               {"fontsize", few        ? "11"
                                                            : numbered ? "8"
                                                                       : "10"}});
  graph.set_default(GraphDrawing::Part::edge, {{"color", "#9a9a9a"}, {"penwidth", many ? "0.7" : "1.3"}});
}

void add_nodes(GraphDrawing& graph, const TopologicalMap& map) {
  const std::size_t count = map.nodes().size();
  const bool inside = count <= most_numbered;
  // A round number, so that the numbers shown are round too.
  std::size_t every = 1;
  for (const std::size_t step : {10U, 20U, 50U, 100U, 200U, 500U, 1000U, 2000U, 5000U, 10000U}) {
    every = step;
    if (count / step <= outside_numbers) break;
  }
  for (const Node& node : map.nodes()) {
    GraphDrawing::Attributes attributes = {
        {"tooltip", fmt::format("node {}: {} ({} image{})", node.id, node.views.front().name,
                                node.views.size(), node.views.size() == 1 ? "" : "s")}};
    const std::string number = std::to_string(node.id);
    if (inside) attributes["label"] = number;
    if (!inside && static_cast<std::size_t>(node.id) % every == 0) attributes["xlabel"] = number;
    if (node.id == map.active()) attributes["fillcolor"] = "#ffd92f";
    graph.add_node(node.id, attributes);
  }
}

void add_edges(GraphDrawing& graph, const TopologicalMap& map) {
  const Strengths strengths = loop_strengths(map);
  const double threshold = map.config().detection.threshold;
  for (const Edge& edge : map.edges()) {
    if (edge.kind == EdgeKind::path) {
      graph.add_edge(edge.from, edge.to, {});
      continue;
    }
    const auto found = strengths.find(std::minmax(edge.from, edge.to));
    const double similarity = found == strengths.end() ? 0 : found->second;
    const double part = threshold > 0 ? (similarity / threshold - 1) / (scale_top - 1) : 1;
    graph.add_edge(
        edge.from, edge.to,
        {{"color", loop_colour(part)},
         {"penwidth", map.nodes().size() > 1500 ? "1" : "2"},
         {"tooltip", fmt::format("loop {} - {}, similarity {:.4g}", edge.from, edge.to, similarity)}});
  }
}

// Title, numbers and the colours of loops as a table in graphviz's HTML.
std::string legend(const TopologicalMap& map, const std::string& title) {
  const auto count = [](std::size_t n, const char* what) {
    return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
  };
  const double threshold = map.config().detection.threshold;
  std::string scale;
  for (int k = 0; k < scale_steps; ++k) {
    scale += fmt::format(R"(<TD BGCOLOR="{}" WIDTH="26" HEIGHT="10"></TD>)",
                         loop_colour(k / static_cast<double>(scale_steps - 1)));
  }
  // Viewers draw text up to a twentieth wider than graphviz reckons: no long text has a neighbour on its
  // right.
  return fmt::format(
      R"(<TABLE BORDER="0" CELLSPACING="0" CELLPADDING="3"><TR><TD><FONT POINT-SIZE="16">{}</FONT></TD></TR>)"
      R"(<TR><TD>{}, {}, {}</TD></TR>)"
      R"(<TR><TD><FONT COLOR="#707070">grey: path; yellow: active node; loops by similarity:</FONT></TD></TR>)"
      R"(<TR><TD><TABLE BORDER="0" CELLSPACING="0" CELLPADDING="3"><TR>)"
      R"(<TD><FONT COLOR="#707070">{:g}  </FONT></TD>{}<TD><FONT COLOR="#707070"> {:g} and above</FONT></TD>)"
      R"(</TR></TABLE></TD></TR></TABLE>)",
      GraphDrawing::escaped(title.empty() ? "topological map" : title),
      count(static_cast<std::size_t>(map.images()), "image"), count(map.nodes().size(), "node"),
      count(static_cast<std::size_t>(map.loops()), "loop closure"), threshold, scale, scale_top * threshold);
}

}  // namespace

void write_map_plot(const std::filesystem::path& path, const TopologicalMap& map, const std::string& title) {
  GraphDrawing graph;
  set_style(graph, map.nodes().size());
  add_nodes(graph, map);
  add_edges(graph, map);
  graph.set_legend(legend(map, title));
  std::string svg;
  try {
    svg = graph.svg(map.nodes().size() <= most_for_stress ? "neato" : "sfdp");
  } catch (const Error& fault) {
    throw Error(path.string() + ": " + fault.what());
  }
  write_file(path, [&svg](std::ostream& out) { out << svg; });
}

}  // namespace sailmap
