// Tables for spreadsheets and scripts. Texts are quoted, numbers are not, and what there is not is empty.
#include <fmt/format.h>

#include <string>

#include "formats.hpp"
#include "sailmap/error.hpp"
#include "text.hpp"

namespace sailmap {
namespace {

std::string field(const std::string& text) { return quoted(text, "\"\""); }

// Node and similarity, or two empty fields.
std::string fields(const Candidate& candidate) {
  return candidate.node < 0 ? "," : fmt::format("{},{}", candidate.node, candidate.similarity);
}

const std::string& name_of(const TopologicalMap& map, int node) {
  return map.nodes()[static_cast<std::size_t>(node)].views.front().name;
}

// What each image did to the map.
void write_images(const TopologicalMap& map, std::ostream& out) {
  out << "image,name,node,new_node,reason,best_node,similarity,runner_up_node,runner_up_similarity,"
         "matched_regions\n";
  for (const Update& update : map.history()) {
    const Detection& d = update.detection;
    out << fmt::format("{},{},{},{},{},{},{},{}\n", update.image, field(update.name), update.node,
                       update.new_node ? 1 : 0, name(d.reason), fields(d.best), fields(d.runner_up),
                       d.matches.size());
  }
}

// A node has the number and the name of the image that made it.
void write_nodes(const TopologicalMap& map, std::ostream& out) {
  out << "node,images,image,name\n";
  for (const Node& node : map.nodes()) {
    out << fmt::format("{},{},{},{}\n", node.id, node.views.size(), node.views.front().image,
                       field(node.views.front().name));
  }
}

void write_edges(const TopologicalMap& map, std::ostream& out) {
  out << "from,to,kind,from_name,to_name\n";
  for (const Edge& edge : map.edges()) {
    out << fmt::format("{},{},{},{},{}\n", edge.from, edge.to, name(edge.kind),
                       field(name_of(map, edge.from)), field(name_of(map, edge.to)));
  }
}

// The accepted detections.
void write_loops(const TopologicalMap& map, std::ostream& out) {
  out << "image,name,node,node_name,similarity,runner_up_node,runner_up_similarity,matched_regions\n";
  for (const Update& update : map.history()) {
    const Detection& d = update.detection;
    if (!d.accepted()) continue;
    out << fmt::format("{},{},{},{},{},{},{}\n", update.image, field(update.name), d.best.node,
                       field(name_of(map, d.best.node)), d.best.similarity, fields(d.runner_up),
                       d.matches.size());
  }
}

struct Table {
  std::string_view name;
  void (*write)(const TopologicalMap&, std::ostream&);
};
constexpr Table tables[] = {
    {"images", write_images}, {"nodes", write_nodes}, {"edges", write_edges}, {"loops", write_loops}};

}  // namespace

std::vector<std::string_view> csv_tables() {
  std::vector<std::string_view> names;
  for (const Table& table : tables) names.push_back(table.name);
  return names;
}

void write_csv(const TopologicalMap& map, std::ostream& out, const ExportOptions& options) {
  std::string known;
  for (const Table& table : tables) {
    if (table.name == options.table) return table.write(map, out);
    known += (known.empty() ? "" : ", ") + std::string(table.name);
  }
  throw Error("no CSV table '" + std::string(options.table) + "'; there are: " + known);
}

}  // namespace sailmap
