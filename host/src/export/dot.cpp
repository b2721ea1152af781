#include <boost/algorithm/string/replace.hpp>

#include "formats.hpp"
#include "text.hpp"

namespace sailmap {
namespace {

// A string that graphviz shows as it is: an ampersand may begin an entity there, and a backslash an escape;
// not even doubled ones are safe (graphviz 2.43 finds the \N in \\N), but entities are.
std::string shown(std::string text) {
  boost::algorithm::replace_all(text, "&", "&amp;");
  boost::algorithm::replace_all(text, "\\", "&#92;");
  return quoted(text, "\\\"");
}

}  // namespace

void write_dot(const TopologicalMap& map, std::ostream& out, const ExportOptions&) {
  out << "graph sailmap {\n  node [shape=circle];\n";
  for (const Node& node : map.nodes()) {
    out << "  " << node.id << " [tooltip=" << shown(node.views.front().name)
        << ", images=" << node.views.size() << "];\n";
  }
  for (const Edge& edge : map.edges()) {
    out << "  " << edge.from << " -- " << edge.to << " [kind=" << name(edge.kind)
        << (edge.kind == EdgeKind::loop ? ", color=red, constraint=false" : "") << "];\n";
  }
  out << "}\n";
}

}  // namespace sailmap
