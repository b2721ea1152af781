#include "graph_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <opencv2/core.hpp>
#include <utility>
#include <vector>

#include "drawing.hpp"
#include "sailmap/error.hpp"

namespace sailmap {
namespace {

// Of the page that the nodes are scaled to, in points, of which graphviz's SVG has 72 an inch and 96 pixels
// an inch.
constexpr double page_width = 860;
constexpr double page_height = 560;

std::mutex graphviz_lock;

// One for the whole process, never freed: graphviz's pango plugin compares the name of the font that it
// measures next with that of the last one, which lives in the context (graphviz 2.42).
GVC_t* graphviz_context() {
  static GVC_t* const context = gvContext();
  return context;
}

// Graphviz's interface takes strings that it copies, and does not change, as char*.
class Chars {
 public:
  explicit Chars(std::string text) : text_(std::move(text)) {}
  operator char*() { return text_.data(); }

 private:
  std::string text_;
};

void set(void* object, const std::string& key, const std::string& value) {
  if (agset(object, Chars(key), Chars(drawing::printable(value))) != 0) {
    throw Error("graphviz has no default of attribute '" + key + "'");
  }
}

std::vector<Agnode_t*> nodes_of(Agraph_t* graph) {
  std::vector<Agnode_t*> out;
  for (Agnode_t* node = agfstnode(graph); node != nullptr; node = agnxtnode(graph, node)) out.push_back(node);
  return out;
}

// Turned so that the points spread most from left to right.
void turn(cv::Mat1d& points) {
  const cv::PCA axes(points, cv::Mat(), cv::PCA::DATA_AS_ROW);
  points = axes.project(points);
}

// Scaled evenly to the page, with its lower left corner at the origin.
void scale(cv::Mat1d& points) {
  double factor = 1e9;
  for (const int axis : {0, 1}) {
    double least = 0;
    double most = 0;
    cv::minMaxLoc(points.col(axis), &least, &most);
    points.col(axis) -= least;
    const double room = axis == 0 ? page_width : page_height;
    if (most > least) factor = std::min(factor, room / (most - least));
  }
  points *= factor;
}

}  // namespace

GraphDrawing::GraphDrawing()
    : turn_(graphviz_lock),
      context_(graphviz_context()),
      graph_(agopen(Chars("map"), Agundirected, nullptr)) {
  agseterr(AGMAX);  // a library does not print
  set_default(Part::graph, {{"overlap", "true"},
                            {"splines", "line"},
                            {"forcelabels", "true"},
                            {"pad", "0.2"},
                            {"fontname", "DejaVu Sans"},
                            {"fontsize", "12"}});
  set_default(Part::node, {{"tooltip", ""}, {"pos", ""}});
  set_default(Part::edge, {{"tooltip", ""}});
}

void GraphDrawing::set_default(Part part, const Attributes& attributes) {
  const int kind = part == Part::graph ? AGRAPH : part == Part::node ? AGNODE : AGEDGE;
  for (const auto& [key, value] : attributes) agattr(graph_.get(), kind, Chars(key), Chars(value));
}

void GraphDrawing::add_node(int id, const Attributes& attributes) {
  Agnode_t* node = agnode(graph_.get(), Chars(std::to_string(id)), 1);
  for (const auto& [key, value] : attributes) set(node, key, value);
}

void GraphDrawing::add_edge(int from, int to, const Attributes& attributes) {
  Agnode_t* a = agnode(graph_.get(), Chars(std::to_string(from)), 1);
  Agnode_t* b = agnode(graph_.get(), Chars(std::to_string(to)), 1);
  Agedge_t* edge = agedge(graph_.get(), a, b, nullptr, 1);
  for (const auto& [key, value] : attributes) set(edge, key, value);
}

void GraphDrawing::set_legend(const std::string& html) {
  char* label = agstrdup_html(graph_.get(), Chars(html));
  agattr(graph_.get(), AGRAPH, Chars("label"), label);
  agstrfree(graph_.get(), label);
}

std::string GraphDrawing::escaped(const std::string& text) {
  std::string out;
  for (const char c : drawing::printable(text)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

void GraphDrawing::arrange(const std::string& engine) {
  const std::vector<Agnode_t*> nodes = nodes_of(graph_.get());
  if (nodes.size() < 2) return;
  if (gvLayout(context_, graph_.get(), engine.c_str()) != 0) throw Error("graphviz cannot lay the graph out");
  cv::Mat1d points(static_cast<int>(nodes.size()), 2);
  for (int i = 0; i < points.rows; ++i) {
    const pointf at = ND_coord(nodes[static_cast<std::size_t>(i)]);
    points(i, 0) = at.x;
    points(i, 1) = at.y;
  }
  gvFreeLayout(context_, graph_.get());
  turn(points);
  scale(points);
  for (int i = 0; i < points.rows; ++i) {
    set(nodes[static_cast<std::size_t>(i)], "pos", fmt::format("{:.2f},{:.2f}", points(i, 0), points(i, 1)));
  }
}

std::string GraphDrawing::render() {
  const bool placed = agnnodes(graph_.get()) >= 2;
  // "nop" keeps the positions that the nodes have.
  if (gvLayout(context_, graph_.get(), placed ? "nop" : "neato") != 0) {
    throw Error("graphviz cannot lay the graph out");
  }
  char* data = nullptr;
  unsigned length = 0;
  const int failed = gvRenderData(context_, graph_.get(), "svg", &data, &length);
  std::string svg = data == nullptr ? std::string() : std::string(data, length);
  gvFreeRenderData(data);
  gvFreeLayout(context_, graph_.get());
  if (failed != 0 || svg.find("</svg>") == std::string::npos) throw Error("graphviz cannot draw the graph");
  return svg;
}

std::map<int, cv::Point2d> GraphDrawing::positions(const std::string& engine) {
  arrange(engine);
  std::map<int, cv::Point2d> out;
  for (Agnode_t* node : nodes_of(graph_.get())) {
    cv::Point2d at;
    // A single node is not arranged, and has none.
    std::sscanf(agget(node, Chars("pos")), "%lf,%lf", &at.x, &at.y);
    out.emplace(std::stoi(agnameof(node)), at);
  }
  return out;
}

std::string GraphDrawing::svg(const std::string& engine) {
  arrange(engine);
  return render();
}

}  // namespace sailmap
