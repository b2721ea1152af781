// An undirected graph laid out and drawn by graphviz. Graphviz keeps state of its own for the whole process:
// objects of this class take turns, by a lock that each holds as long as it lives.
#pragma once

#include <graphviz/gvc.h>

#include <map>
#include <memory>
#include <mutex>
#include <opencv2/core/types.hpp>
#include <string>

namespace sailmap {

class GraphDrawing {
 public:
  // By graphviz's names.
  using Attributes = std::map<std::string, std::string>;
  enum class Part { graph, node, edge };

  GraphDrawing();

  void set_default(Part part, const Attributes& attributes);
  // Attributes of nodes and edges must have a default; "tooltip" has one.
  void add_node(int id, const Attributes& attributes);
  void add_edge(int from, int to, const Attributes& attributes);
  // Beneath the graph, in graphviz's HTML; text in it must be `escaped`.
  void set_legend(const std::string& html);
  static std::string escaped(const std::string& text);

  // Laid out by `engine` (neato, sfdp, ...), turned so that it is wider than high, and scaled to a page of
  // about 1200 x 900 pixels. Once per object. Throws Error when graphviz fails.
  std::string svg(const std::string& engine);

  // Where `engine` lays the nodes out, by id: turned and scaled as above, points, y upwards. Instead of
  // svg(). Throws Error when graphviz fails.
  std::map<int, cv::Point2d> positions(const std::string& engine);

 private:
  struct Close {
    void operator()(Agraph_t* graph) const { agclose(graph); }
  };
  void arrange(const std::string& engine);
  [[nodiscard]] std::string render();

  std::unique_lock<std::mutex> turn_;
  GVC_t* context_;
  std::unique_ptr<Agraph_t, Close> graph_;
};

}  // namespace sailmap
