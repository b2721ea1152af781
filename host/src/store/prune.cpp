#include <map>
#include <set>
#include <vector>

#include "connection.hpp"
#include "json_map.hpp"
#include "parts.hpp"
#include "replace_file.hpp"
#include "sailmap/map_maintenance.hpp"
#include "sailmap/map_store.hpp"
#include "schema.hpp"
#include "write_lock.hpp"
#include "write_rows.hpp"

namespace sailmap {

using namespace store;

namespace {

// Which node each node becomes a part of; most stay themselves.
std::vector<int> join_similar(const TopologicalMap& map, double similar) {
  std::vector<int> becomes(map.nodes().size());
  for (std::size_t n = 0; n < becomes.size(); ++n) becomes[n] = static_cast<int>(n);
  // A path edge leads to the node that was made after the one it comes from.
  for (const Edge& edge : map.edges()) {
    const auto to = static_cast<std::size_t>(edge.to);
    if (edge.kind != EdgeKind::path || becomes[to] != edge.to || edge.to <= edge.from) continue;
    const int kept = becomes[static_cast<std::size_t>(edge.from)];
    const Signature& before = map.nodes()[static_cast<std::size_t>(kept)].views.front().signature;
    const Signature& after = map.nodes()[to].views.front().signature;
    if (match(after, before, map.config().match).similarity >= similar) becomes[to] = kept;
  }
  return becomes;
}

std::set<int> visited_lately(const TopologicalMap& map, int sessions) {
  const auto& starts = map.sessions();
  const std::size_t count = starts.size();
  const auto kept = std::min(count, static_cast<std::size_t>(sessions));
  std::set<int> nodes;
  for (auto i = static_cast<std::size_t>(starts[count - kept]); i < map.history().size(); ++i) {
    nodes.insert(map.history()[i].node);
  }
  return nodes;
}

// Images and all that names a node go along; the joined nodes' own views are no longer needed.
void join(MapParts& parts, const std::vector<int>& becomes) {
  const auto follow = [&](int& node) {
    if (node >= 0) node = becomes[static_cast<std::size_t>(node)];
  };
  for (ImageParts& image : parts.images) {
    const int before = image.image.node;
    follow(image.image.node);
    if (image.image.node != before && image.image.is_view != 0) {
      image.image.is_view = 0;
      image.signature.reset();
    }
    follow(image.detection.best_node);
    follow(image.detection.runner_up_node);
  }
  for (EdgeRow& edge : parts.edges) {
    follow(edge.from_node);
    follow(edge.to_node);
  }
}

MapParts parts_of(const std::filesystem::path& path) {
  const Connection connection = connect_to_read(path);
  const SQLite::Transaction moment(*connection);
  check_schema(*connection);
  return read_parts(*connection);
}

// Of a JSON map by way of a database beside `beside`.
MapParts parts_of_json(const std::filesystem::path& path, const std::filesystem::path& beside) {
  const std::filesystem::path database = beside.string() + ".migrated";
  const StoredMap stored = read_json_map(path);
  MapStore(database).save(stored.map, stored.frontend);
  MapParts parts = parts_of(database);
  remove_with_log(database);
  return parts;
}

}  // namespace

MapPruning prune_map(const std::filesystem::path& from, const std::filesystem::path& to,
                     const PruneOptions& options) {
  std::error_code unknown;
  const bool in_place = std::filesystem::equivalent(from, to, unknown);
  if (is_there(to) && !in_place) throw Error(to.string() + ": exists already");
  return with_file(to, [&] {
    const WriteLock lock(to);
    const TopologicalMap map = MapStore(from).load().map;
    MapParts parts = is_json(from) ? parts_of_json(from, to) : parts_of(from);
    const std::vector<int> becomes = join_similar(map, options.similar);
    std::set<int> kept(becomes.begin(), becomes.end());
    MapPruning pruning;
    pruning.joined = static_cast<int>(becomes.size() - kept.size());
    join(parts, becomes);
    if (options.unvisited > 0) {
      std::set<int> visited;
      for (const int node : visited_lately(map, options.unvisited)) {
        visited.insert(becomes[static_cast<std::size_t>(node)]);
      }
      std::erase_if(parts.images,
                    [&](const ImageParts& image) { return !visited.contains(image.image.node); });
      pruning.dropped = static_cast<int>(kept.size() - visited.size());
      kept = std::move(visited);
    }
    if (kept.empty()) throw Error("nothing would be left of this map");
    pruning.nodes = static_cast<int>(kept.size());
    const MapParts whole = made_whole(std::move(parts));
    replace_file(to, [&](SQLite::Database& database) { write_parts(database, whole); });
    return pruning;
  });
}

}  // namespace sailmap
