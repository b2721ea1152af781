#include "read_map.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "map/config_json.hpp"
#include "sailmap/error.hpp"
#include "signature_bytes.hpp"

namespace sailmap::store {
namespace {

// Rows are numbered without a gap.
void demand_next(const char* table, int id, std::size_t count) {
  if (id < 0 || static_cast<std::size_t>(id) != count) {
    throw Error(std::string("table ") + table + " lacks row " + std::to_string(count));
  }
}

// The image that made each node, and the images as far as the map's history holds them.
struct Images {
  std::vector<Update> history;
  std::vector<char> is_view;
};

Images read_images(SQLite::Database& database) {
  Images images;
  for_each_row<ImageRow>(database, [&](ImageRow row) {
    demand_next(ImageRow::table, row.id, images.history.size());
    images.is_view.push_back(row.is_view != 0);
    images.history.push_back({row.id, std::move(row.name), row.node, row.new_node != 0, {}});
  });
  std::size_t detections = 0;
  for_each_row<DetectionRow>(database, [&](const DetectionRow& row) {
    demand_next(DetectionRow::table, row.id, detections);
    if (++detections > images.history.size()) throw Error("a detection of an image that was never added");
    images.history[detections - 1].detection = detection_from_row(row);
  });
  if (detections != images.history.size()) demand_next(DetectionRow::table, -1, detections);
  return images;
}

std::vector<Node> read_nodes(SQLite::Database& database, const Images& images) {
  std::vector<Node> nodes;
  for_each_row<NodeRow>(database, [&](const NodeRow& row) {
    demand_next(NodeRow::table, row.id, nodes.size());
    nodes.push_back({row.id, {}});
  });
  for_each_row<SignatureRow>(database, [&](const SignatureRow& row) {
    const auto image = static_cast<std::size_t>(row.id);
    if (row.id < 0 || image >= images.history.size())
      throw Error("a signature of an image that was never added");
    if (!images.is_view[image]) return;
    const Update& update = images.history[image];
    if (update.node < 0 || static_cast<std::size_t>(update.node) >= nodes.size()) {
      throw Error("image " + std::to_string(image) + " belongs to no node");
    }
    nodes[static_cast<std::size_t>(update.node)].views.push_back(
        {row.id, update.name, signature_from_row(row)});
  });
  return nodes;
}

}  // namespace

Detection detection_from_row(const DetectionRow& row) {
  return {reason_from_name(row.reason),
          {row.best_node, row.best_similarity},
          {row.runner_up_node, row.runner_up_similarity},
          matches_from_bytes(row.matches)};
}

MapConfig config_of(const MapRow& row) {
  try {
    return map_config_from_json(nlohmann::ordered_json::parse(row.parameters));
  } catch (const nlohmann::ordered_json::exception& fault) {
    throw Error(std::string("the parameters are damaged: ") + fault.what());
  }
}

MapRow read_map_row(SQLite::Database& database) {
  auto row = RowFinder<MapRow>(database).find(0);
  if (!row) throw Error("damaged: its parameters are lost");
  return std::move(*row);
}

std::vector<SessionRow> read_sessions(SQLite::Database& database) {
  std::vector<SessionRow> sessions;
  for_each_row<SessionRow>(database, [&](SessionRow row) {
    demand_next(SessionRow::table, row.id, sessions.size());
    sessions.push_back(std::move(row));
  });
  return sessions;
}

StoredMap read_map(SQLite::Database& database) {
  const MapRow row = read_map_row(database);
  Images images = read_images(database);
  std::vector<Node> nodes = read_nodes(database, images);
  std::vector<Edge> edges;
  for_each_row<EdgeRow>(database, [&](const EdgeRow& edge) {
    demand_next(EdgeRow::table, edge.id, edges.size());
    edges.push_back({edge.from_node, edge.to_node, edge_kind_from_name(edge.kind)});
  });
  std::vector<int> sessions;
  for (const SessionRow& session : read_sessions(database)) sessions.push_back(session.first_image);
  const int active = images.history.empty() ? -1 : images.history.back().node;
  return {TopologicalMap(config_of(row), std::move(nodes), std::move(edges), std::move(images.history),
                         active, std::move(sessions)),
          row.frontend};
}

}  // namespace sailmap::store
