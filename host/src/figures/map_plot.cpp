// A topological map as a graph, laid out by graphviz.
#include <fmt/format.h>
#include <graphviz/gvc.h>

#include <algorithm>
#include <memory>
#include <string>

#include "sailmap/error.hpp"
#include "sailmap/figures.hpp"
#include "sailmap/file.hpp"

namespace sailmap {
namespace {

// Above so many nodes their numbers would only be clutter.
constexpr std::size_t most_labels = 300;

struct Close {
  void operator()(Agraph_t* graph) const { agclose(graph); }
  void operator()(GVC_t* context) const { gvFreeContext(context); }
};

void set(void* object, const char* key, const std::string& value) {
  agsafeset(object, const_cast<char*>(key), const_cast<char*>(value.c_str()), const_cast<char*>(""));
}

Agnode_t* node(Agraph_t* graph, int id) {
  return agnode(graph, const_cast<char*>(std::to_string(id).c_str()), 1);
}

// Similarity of the strongest detection that joins two nodes; 0 when there is none.
double strength(const TopologicalMap& map, const Edge& edge) {
  double best = 0;
  int active = -1;
  for (const Update& update : map.history()) {
    const bool joins =
        (active == edge.from && update.node == edge.to) || (active == edge.to && update.node == edge.from);
    if (joins && update.detection.accepted()) best = std::max(best, update.detection.best.similarity);
    active = update.node;
  }
  return best;
}

// From orange for a loop at the threshold to dark red for one at four times the threshold.
std::string loop_colour(double similarity, double threshold) {
  const double part = std::clamp((similarity / std::max(threshold, 1e-9) - 1) / 3, 0.0, 1.0);
  const auto mix = [part](int weak, int strong) { return static_cast<int>(weak + part * (strong - weak)); };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(253, 165), mix(174, 0), mix(97, 38));
}

void add_nodes(Agraph_t* graph, const TopologicalMap& map) {
  const bool labelled = map.nodes().size() <= most_labels;
  for (const Node& n : map.nodes()) {
    Agnode_t* drawn = node(graph, n.id);
    set(drawn, "tooltip", fmt::format("node {}: {} ({} images)", n.id, n.views.front().name, n.views.size()));
    set(drawn, "label", labelled ? std::to_string(n.id) : "");
    if (n.id == map.active()) set(drawn, "fillcolor", "#ffd92f");
  }
}

void add_edges(Agraph_t* graph, const TopologicalMap& map) {
  for (const Edge& e : map.edges()) {
    Agedge_t* drawn = agedge(graph, node(graph, e.from), node(graph, e.to), nullptr, 1);
    if (e.kind == EdgeKind::path) continue;
    const double similarity = strength(map, e);
    set(drawn, "color", loop_colour(similarity, map.config().detection.threshold));
    set(drawn, "penwidth", "2.5");
    set(drawn, "tooltip", fmt::format("loop {} - {}, similarity {:.1f}", e.from, e.to, similarity));
  }
}

std::string laid_out(Agraph_t* graph, const std::string& engine, const std::string& name) {
  const std::unique_ptr<GVC_t, Close> context(gvContext());
  if (gvLayout(context.get(), graph, engine.c_str()) != 0)
    throw Error(name + ": graphviz cannot lay the map out");
  char* data = nullptr;
  unsigned length = 0;
  const int failed = gvRenderData(context.get(), graph, "svg", &data, &length);
  std::string svg(data == nullptr ? "" : std::string(data, length));
  gvFreeRenderData(data);
  gvFreeLayout(context.get(), graph);
  if (failed != 0 || svg.empty()) throw Error(name + ": graphviz cannot draw the map");
  return svg;
}

}  // namespace

void write_map_plot(const std::filesystem::path& path, const TopologicalMap& map, const std::string& title) {
  agseterr(AGMAX);  // a library does not print
  const std::unique_ptr<Agraph_t, Close> graph(agopen(const_cast<char*>("sailmap"), Agundirected, nullptr));
  Agraph_t* g = graph.get();
  set(g, "label",
      fmt::format("{}: {} images, {} nodes, {} loop closures (yellow: active node; red: loops)", title,
                  map.images(), map.nodes().size(), map.loops()));
  set(g, "fontname", "Helvetica");
  set(g, "fontsize", "16");
  set(g, "overlap", "true");
  set(g, "outputorder", "edgesfirst");
  agattr(g, AGNODE, const_cast<char*>("shape"), const_cast<char*>("circle"));
  agattr(g, AGNODE, const_cast<char*>("style"), const_cast<char*>("filled"));
  agattr(g, AGNODE, const_cast<char*>("fillcolor"), const_cast<char*>("#deebf7"));
  agattr(g, AGNODE, const_cast<char*>("color"), const_cast<char*>("#6baed6"));
  agattr(g, AGNODE, const_cast<char*>("fixedsize"), const_cast<char*>("true"));
  agattr(g, AGNODE, const_cast<char*>("width"), const_cast<char*>("0.3"));
  agattr(g, AGNODE, const_cast<char*>("fontsize"), const_cast<char*>("9"));
  agattr(g, AGNODE, const_cast<char*>("fontname"), const_cast<char*>("Helvetica"));
  agattr(g, AGEDGE, const_cast<char*>("color"), const_cast<char*>("#969696"));
  agattr(g, AGEDGE, const_cast<char*>("penwidth"), const_cast<char*>("1.2"));
  add_nodes(g, map);
  add_edges(g, map);
  const std::string svg = laid_out(g, map.nodes().size() > 200 ? "sfdp" : "neato", path.string());
  write_file(path, [&svg](std::ostream& out) { out << svg; });
}

}  // namespace sailmap
