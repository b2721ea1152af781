#include "parts.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "read_map.hpp"
#include "sailmap/error.hpp"
#include "write_rows.hpp"

namespace sailmap::store {
namespace {

// A node that has lost its views is stood for by the first of its images that can be compared.
void give_nodes_views(std::vector<ImageParts>& images) {
  std::set<int> with_view;
  for (ImageParts& image : images) {
    if (!image.signature) image.image.is_view = 0;
    if (image.image.is_view != 0) with_view.insert(image.image.node);
  }
  for (ImageParts& image : images) {
    if (image.signature && with_view.insert(image.image.node).second) image.image.is_view = 1;
  }
}

using Numbers = std::map<int, int>;  // from old to new

// Nodes are numbered by age.
Numbers number_nodes(const std::vector<ImageParts>& images) {
  Numbers numbers;
  for (const ImageParts& image : images) {
    if (image.image.is_view != 0) numbers.emplace(image.image.node, static_cast<int>(numbers.size()));
  }
  return numbers;
}

int lookup(const Numbers& numbers, int old) {
  const auto found = numbers.find(old);
  return found == numbers.end() ? -1 : found->second;
}

void renumber_candidate(const Numbers& nodes, int& node, double& similarity) {
  node = lookup(nodes, node);
  if (node < 0) similarity = 0;
}

void renumber_detection(DetectionRow& d, const ImageRow& image, const Numbers& nodes) {
  renumber_candidate(nodes, d.best_node, d.best_similarity);
  renumber_candidate(nodes, d.runner_up_node, d.runner_up_similarity);
  const bool accepted = d.reason == name(Reason::accepted);
  if (d.best_node >= 0 && !(accepted && image.new_node != 0)) return;
  d.matches.clear();
  if (!accepted) return;
  d = {d.id, std::string(name(Reason::no_nodes)), -1, 0, -1, 0, {}};
}

void renumber_image(ImageParts& parts, int id, const Numbers& nodes, std::set<int>& seen) {
  parts.image.id = parts.detection.id = id;
  if (parts.signature) parts.signature->id = id;
  if (parts.thumbnail) parts.thumbnail->id = id;
  parts.image.node = lookup(nodes, parts.image.node);
  parts.image.new_node = seen.insert(parts.image.node).second ? 1 : 0;
  renumber_detection(parts.detection, parts.image, nodes);
}

std::vector<EdgeRow> renumber_edges(const std::vector<EdgeRow>& edges, const Numbers& nodes) {
  std::vector<EdgeRow> kept;
  std::set<std::tuple<int, int, std::string>> seen;
  for (const EdgeRow& edge : edges) {
    const int from = lookup(nodes, edge.from_node);
    const int to = lookup(nodes, edge.to_node);
    if (from < 0 || to < 0 || from == to) continue;
    if (!seen.insert({std::min(from, to), std::max(from, to), edge.kind}).second) continue;
    kept.push_back({static_cast<int>(kept.size()), from, to, edge.kind});
  }
  return kept;
}

// `old_ids`: the images' former numbers, rising.
std::vector<SessionRow> renumber_sessions(std::vector<SessionRow> sessions, const std::vector<int>& old_ids) {
  if (sessions.empty()) sessions.emplace_back();
  sessions.front().first_image = 0;
  std::vector<SessionRow> kept;
  for (std::size_t s = 0; s < sessions.size(); ++s) {
    const auto begin = std::ranges::lower_bound(old_ids, sessions[s].first_image);
    const auto end = s + 1 < sessions.size() ? std::ranges::lower_bound(old_ids, sessions[s + 1].first_image)
                                             : old_ids.end();
    if (begin >= end && s > 0) continue;
    SessionRow row = sessions[s];
    row.id = static_cast<int>(kept.size());
    row.first_image = static_cast<int>(begin - old_ids.begin());
    row.images = static_cast<int>(end - begin);
    if (!kept.empty() && kept.back().first_image == row.first_image) kept.pop_back();
    row.id = static_cast<int>(kept.size());
    kept.push_back(std::move(row));
  }
  return kept;
}

}  // namespace

MapParts made_whole(MapParts parts) {
  give_nodes_views(parts.images);
  const Numbers nodes = number_nodes(parts.images);
  std::erase_if(parts.images, [&](const ImageParts& image) { return lookup(nodes, image.image.node) < 0; });
  std::vector<int> old_ids;
  std::set<int> seen;
  for (ImageParts& image : parts.images) {
    old_ids.push_back(image.image.id);
    renumber_image(image, static_cast<int>(old_ids.size()) - 1, nodes, seen);
  }
  parts.edges = renumber_edges(parts.edges, nodes);
  parts.sessions = renumber_sessions(std::move(parts.sessions), old_ids);
  return parts;
}

void write_parts(SQLite::Database& database, const MapParts& parts) {
  RowWriter writer(database);
  writer.put(parts.map);
  for (const SessionRow& session : parts.sessions) writer.put(session);
  std::set<int> nodes;
  for (const ImageParts& image : parts.images) {
    writer.put(image.image);
    writer.put(image.detection);
    if (image.signature) writer.put(*image.signature);
    if (image.thumbnail) writer.put(*image.thumbnail);
    if (image.image.is_view != 0 && nodes.insert(image.image.node).second) {
      writer.put(NodeRow{image.image.node, image.image.id});
    }
  }
  for (const EdgeRow& edge : parts.edges) writer.put(edge);
}

MapParts read_parts(SQLite::Database& database) {
  MapParts parts;
  parts.map = read_map_row(database);
  parts.sessions = read_sessions(database);
  for_each_row<ImageRow>(database, [&](ImageRow row) {
    parts.images.push_back({std::move(row), {}, {}, {}});
  });
  const auto image_of = [&](int id) -> ImageParts& {
    if (id < 0 || static_cast<std::size_t>(id) >= parts.images.size()) {
      throw Error("there is more about image " + std::to_string(id) + ", which was never added");
    }
    return parts.images[static_cast<std::size_t>(id)];
  };
  for_each_row<DetectionRow>(database,
                             [&](DetectionRow row) { image_of(row.id).detection = std::move(row); });
  for_each_row<SignatureRow>(database,
                             [&](SignatureRow row) { image_of(row.id).signature = std::move(row); });
  for_each_row<ThumbnailRow>(database,
                             [&](ThumbnailRow row) { image_of(row.id).thumbnail = std::move(row); });
  for_each_row<EdgeRow>(database, [&](EdgeRow row) { parts.edges.push_back(std::move(row)); });
  return parts;
}

}  // namespace sailmap::store
