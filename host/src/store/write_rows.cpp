#include "write_rows.hpp"

#include <nlohmann/json.hpp>
#include <unordered_map>

#include "map/config_json.hpp"
#include "signature_bytes.hpp"

namespace sailmap::store {

void RowWriter::put_map(const MapConfig& config, const std::string& frontend) {
  put(MapRow{0, SAILMAP_VERSION, frontend, to_json(config).dump()});
}

void RowWriter::put_image(const Update& update, bool is_view, const Signature* signature,
                          const ImageNote& note) {
  put(ImageRow{update.image, update.name, note.time, update.node, update.new_node ? 1 : 0, is_view ? 1 : 0});
  if (signature != nullptr) {
    put(SignatureRow{update.image, signature->width, signature->height, regions_to_bytes(signature->regions),
                     place_to_bytes(signature->place)});
  }
  const Detection& d = update.detection;
  put(DetectionRow{update.image, std::string(name(d.reason)), d.best.node, d.best.similarity,
                   d.runner_up.node, d.runner_up.similarity, matches_to_bytes(d.matches)});
  if (!note.thumbnail.empty()) put(ThumbnailRow{update.image, note.thumbnail});
}

void write_map(SQLite::Database& database, const TopologicalMap& map, const std::string& frontend) {
  RowWriter writer(database);
  writer.put_map(map.config(), frontend);
  std::unordered_map<int, const Signature*> views;
  for (const Node& node : map.nodes()) {
    writer.put(NodeRow{node.id, node.views.front().image});
    for (const View& view : node.views) views[view.image] = &view.signature;
  }
  for (const Update& update : map.history()) {
    const auto view = views.find(update.image);
    const Signature* signature = view == views.end() ? nullptr : view->second;
    writer.put_image(update, signature != nullptr, signature, {});
  }
  int id = 0;
  for (const Edge& edge : map.edges()) writer.put_edge(id++, edge);
  const auto& sessions = map.sessions();
  for (std::size_t s = 0; s < sessions.size(); ++s) {
    const int end = s + 1 < sessions.size() ? sessions[s + 1] : map.images();
    writer.put(SessionRow{static_cast<int>(s), "", 0, sessions[s], end - sessions[s], 0, 0});
  }
}

}  // namespace sailmap::store
