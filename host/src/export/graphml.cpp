#include <pugixml.hpp>
#include <string>

#include "formats.hpp"
#include "text.hpp"

namespace sailmap {
namespace {

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

}  // namespace

void write_graphml(const TopologicalMap& map, std::ostream& out, const ExportOptions&) {
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
    add_data(xml, "name", xml_text(node.views.front().name));
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

}  // namespace sailmap
