#include <boost/algorithm/string/replace.hpp>

#include "formats.hpp"
#include "text.hpp"

namespace sailmap {
namespace {

// A string that graphviz shows as it is: backslashes are its escapes (graphviz 2.43 resolves those of a
// tooltip twice, so that there the name of an image with \N in it shows a number), and an ampersand may begin
// an entity.
std::string shown(std::string text) {
  boost::algorithm::replace_all(text, "&", "&amp;");
  boost::algorithm::replace_all(text, "\\", "\\\\");
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
