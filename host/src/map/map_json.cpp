#include "map_json.hpp"

#include <string>
#include <utility>

#include "config_json.hpp"
#include "io/json_numbers.hpp"

namespace sailmap {

using io::whole_number;
using nlohmann::ordered_json;

ordered_json to_json(const TopologicalMap& map) {
  ordered_json nodes = ordered_json::array();
  for (const Node& node : map.nodes()) {
    ordered_json views = ordered_json::array();
    for (const View& view : node.views) {
      views.push_back({{"image", view.image}, {"name", view.name}, {"signature", to_json(view.signature)}});
    }
    nodes.push_back({{"id", node.id}, {"views", std::move(views)}});
  }
  ordered_json edges = ordered_json::array();
  for (const Edge& edge : map.edges()) {
    edges.push_back({{"from", edge.from}, {"to", edge.to}, {"kind", name(edge.kind)}});
  }
  ordered_json images = ordered_json::array();
  for (const Update& update : map.history()) {
    images.push_back({{"image", update.image},
                      {"name", update.name},
                      {"node", update.node},
                      {"new_node", update.new_node},
                      {"detection", to_json(update.detection)}});
  }
  return {{"config", to_json(map.config())},
          {"active", map.active()},
          {"nodes", std::move(nodes)},
          {"edges", std::move(edges)},
          {"images", std::move(images)}};
}

TopologicalMap map_from_json(const ordered_json& json) {
  std::vector<Node> nodes;
  for (const auto& node : json.at("nodes")) {
    Node out{whole_number(node.at("id")), {}};
    for (const auto& view : node.at("views")) {
      out.views.push_back({whole_number(view.at("image")), view.at("name").get<std::string>(),
                           signature_from_json(view.at("signature"))});
    }
    nodes.push_back(std::move(out));
  }
  std::vector<Edge> edges;
  for (const auto& edge : json.at("edges")) {
    edges.push_back({whole_number(edge.at("from")), whole_number(edge.at("to")),
                     edge_kind_from_name(edge.at("kind").get<std::string>())});
  }
  std::vector<Update> history;
  for (const auto& image : json.at("images")) {
    history.push_back({whole_number(image.at("image")), image.at("name").get<std::string>(),
                       whole_number(image.at("node")), image.at("new_node").get<bool>(),
                       detection_from_json(image.at("detection"))});
  }
  return {map_config_from_json(json.at("config")), std::move(nodes), std::move(edges), std::move(history),
          whole_number(json.at("active"))};
}

}  // namespace sailmap
