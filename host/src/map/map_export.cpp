// A map for graphviz, networkx, pose-graph tools, spreadsheets and scripts.
#include "sailmap/map_export.hpp"

#include <pugixml.hpp>
#include <string>

#include "map_json.hpp"
#include "sailmap/error.hpp"

namespace sailmap {
namespace {

const std::string& first_name(const Node& node) { return node.views.front().name; }

// `text` in double quotes, each quote inside written as `escaped_quote`; backslashes doubled where the format
// wants it.
std::string quoted(const std::string& text, const char* escaped_quote, bool double_backslash) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') {
      out += escaped_quote;
    } else if (c == '\\' && double_backslash) {
      out += "\\\\";
    } else {
      out += c;
    }
  }
  return out + "\"";
}

void write_dot(const TopologicalMap& map, std::ostream& out) {
  out << "graph sailmap {\n  node [shape=circle];\n";
  for (const Node& node : map.nodes()) {
    out << "  " << node.id << " [tooltip=" << quoted(first_name(node), "\\\"", true)
        << ", images=" << node.views.size() << "];\n";
  }
  for (const Edge& edge : map.edges()) {
    out << "  " << edge.from << " -- " << edge.to << " [kind=" << name(edge.kind)
        << (edge.kind == EdgeKind::loop ? ", color=red, constraint=false" : "") << "];\n";
  }
  out << "}\n";
}

void add_key(pugi::xml_node graphml, const char* id, const char* target, const char* type) {
  pugi::xml_node key = graphml.append_child("key");
  key.append_attribute("id") = id;
  key.append_attribute("for") = target;
  key.append_attribute("attr.name") = id;
  key.append_attribute("attr.type") = type;
}

void add_data(pugi::xml_node parent, const char* key, const std::string& value) {
  pugi::xml_node data = parent.append_child("data");
  data.append_attribute("key") = key;
  data.text().set(value.c_str());
}

void write_graphml(const TopologicalMap& map, std::ostream& out) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node graphml = document.append_child("graphml");
  graphml.append_attribute("xmlns") = "http://graphml.graphdrawing.org/xmlns";
  add_key(graphml, "name", "node", "string");
  add_key(graphml, "images", "node", "int");
  add_key(graphml, "kind", "edge", "string");
  pugi::xml_node graph = graphml.append_child("graph");
  graph.append_attribute("edgedefault") = "undirected";
  for (const Node& node : map.nodes()) {
    pugi::xml_node xml = graph.append_child("node");
    xml.append_attribute("id") = node.id;
    add_data(xml, "name", first_name(node));
    add_data(xml, "images", std::to_string(node.views.size()));
  }
  for (const Edge& edge : map.edges()) {
    pugi::xml_node xml = graph.append_child("edge");
    xml.append_attribute("source") = edge.from;
    xml.append_attribute("target") = edge.to;
    add_data(xml, "kind", std::string(name(edge.kind)));
  }
  document.save(out, "  ");
}

// A topological map has no metric positions: path edges are given as unit steps ahead and loops as the same
// place, a start for an optimiser that has odometry to put in.
void write_g2o(const TopologicalMap& map, std::ostream& out) {
  constexpr const char* information = "1 0 0 1 0 1";
  for (const Node& node : map.nodes()) out << "VERTEX_SE2 " << node.id << ' ' << node.id << " 0 0\n";
  for (const Edge& edge : map.edges()) {
    out << "EDGE_SE2 " << edge.from << ' ' << edge.to << (edge.kind == EdgeKind::path ? " 1 0 0 " : " 0 0 0 ")
        << information << '\n';
  }
}

// One line per image: what it did to the map.
void write_csv(const TopologicalMap& map, std::ostream& out) {
  out << "image,name,node,new_node,reason,best_node,similarity,runner_up_node,runner_up_similarity,"
         "matched_regions\n";
  const auto candidate = [&out](const Candidate& c) {
    if (c.node >= 0) {
      out << ',' << c.node << ',' << c.similarity;
    } else {
      out << ",,";
    }
  };
  for (const Update& update : map.history()) {
    out << update.image << ',' << quoted(update.name, "\"\"", false) << ',' << update.node << ','
        << (update.new_node ? 1 : 0) << ',' << name(update.detection.reason);
    candidate(update.detection.best);
    candidate(update.detection.runner_up);
    out << ',' << update.detection.matches.size() << '\n';
  }
}

void write_json(const TopologicalMap& map, std::ostream& out) {
  out << to_json(map).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

struct Entry {
  std::string_view format;
  void (*write)(const TopologicalMap&, std::ostream&);
};
constexpr Entry entries[] = {{"dot", write_dot},
                             {"graphml", write_graphml},
                             {"g2o", write_g2o},
                             {"csv", write_csv},
                             {"json", write_json}};

}  // namespace

std::vector<std::string_view> export_formats() {
  std::vector<std::string_view> formats;
  for (const Entry& entry : entries) formats.push_back(entry.format);
  return formats;
}

void export_map(const TopologicalMap& map, std::string_view format, std::ostream& out) {
  std::string known;
  for (const Entry& entry : entries) {
    if (entry.format == format) return entry.write(map, out);
    known += (known.empty() ? "" : ", ") + std::string(entry.format);
  }
  throw Error("no export format '" + std::string(format) + "'; there are: " + known);
}

}  // namespace sailmap
