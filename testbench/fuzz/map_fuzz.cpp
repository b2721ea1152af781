// Map files: one that can be read is consistent, is the same when saved and read again, and can be continued.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "foreign_file.hpp"
#include "sailmap/map_export.hpp"
#include "sailmap/map_maintenance.hpp"
#include "sailmap/map_store.hpp"

namespace {

using namespace sailmap;
using fuzz::demand;

bool is_node(const TopologicalMap& map, int id) {
  return id >= 0 && id < static_cast<int>(map.nodes().size());
}

void check_signature(const Signature& signature) {
  demand(signature.width > 0 && signature.height > 0, "an image has pixels");
  for (const Region& region : signature.regions) {
    demand(region.x >= 0 && region.x < signature.width && region.y >= 0 && region.y < signature.height,
           "a region is in its image");
    demand(std::isfinite(region.saliency) &&
               std::ranges::all_of(region.descriptor, [](float v) { return std::isfinite(v); }),
           "a region's numbers are finite");
  }
}

void check_detection(const TopologicalMap& map, const Detection& detection) {
  for (const Candidate& candidate : {detection.best, detection.runner_up}) {
    demand(candidate.node == -1 || is_node(map, candidate.node), "a candidate is a node");
    demand(std::isfinite(candidate.similarity), "a similarity is finite");
  }
  for (const RegionMatch& match : detection.matches) {
    demand(match.query >= 0 && match.candidate >= 0, "matched regions have numbers");
  }
}

void check(const TopologicalMap& map) {
  demand(map.nodes().empty() ? map.active() == -1 : is_node(map, map.active()), "the active node exists");
  for (std::size_t i = 0; i < map.nodes().size(); ++i) {
    const Node& node = map.nodes()[i];
    demand(node.id == static_cast<int>(i) && !node.views.empty(), "nodes are numbered and have images");
    for (const View& view : node.views) {
      demand(view.image >= 0 && view.image < map.images(), "a node's image is one of the map");
      check_signature(view.signature);
    }
  }
  for (const Edge& edge : map.edges())
    demand(is_node(map, edge.from) && is_node(map, edge.to), "edges join nodes");
  for (std::size_t i = 0; i < map.history().size(); ++i) {
    demand(map.history()[i].image == static_cast<int>(i), "the history is in order");
    demand(is_node(map, map.history()[i].node), "an image belongs to a node");
    check_detection(map, map.history()[i].detection);
  }
}

bool same(const Detection& a, const Detection& b) {
  return a.reason == b.reason && a.best == b.best && a.runner_up == b.runner_up && a.matches == b.matches;
}

bool same(const TopologicalMap& a, const TopologicalMap& b) {
  const auto same_view = [](const View& v, const View& w) {
    return v.image == w.image && v.name == w.name && v.signature == w.signature;
  };
  const auto same_node = [&](const Node& m, const Node& n) {
    return m.id == n.id && std::ranges::equal(m.views, n.views, same_view);
  };
  const auto same_update = [](const Update& u, const Update& v) {
    return u.image == v.image && u.name == v.name && u.node == v.node && u.new_node == v.new_node &&
           same(u.detection, v.detection);
  };
  return a.active() == b.active() && a.edges() == b.edges() &&
         std::ranges::equal(a.nodes(), b.nodes(), same_node) &&
         std::ranges::equal(a.history(), b.history(), same_update);
}

std::string content_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

StoredMap saved_and_loaded(const std::filesystem::path& path, const StoredMap& stored) {
  const MapStore store(path);
  store.save(stored.map, stored.frontend);
  return store.load();
}

// What checking says of a file agrees with whether it can be loaded; what is recovered of it is sound.
void check_and_recover(const std::filesystem::path& path, bool loads) {
  const auto checked = fuzz::read_foreign(path, [&] { return check_map(path); });
  if (checked) {
    for (const std::string& fault : checked->faults) demand(fuzz::is_one_line(fault), "a fault is one line");
    demand(!checked->faults.empty() || loads, "a sound map can be loaded");
  }
  const std::filesystem::path rescued = path.string() + ".rescued";
  const auto recovery = fuzz::read_foreign("", [&] { return recover_map(path, rescued); });
  if (recovery) {
    demand(check_map(rescued).faults.empty(), "what is recovered is sound");
    std::filesystem::remove(rescued);
  }
}

// At one place, a second apart.
std::vector<TimedPose> poses_for(const TopologicalMap& map) {
  std::vector<TimedPose> poses(map.history().size());
  for (std::size_t i = 0; i < poses.size(); ++i) poses[i].time = static_cast<double>(i);
  return poses;
}

// The last image once more, or a flat one.
void continue_map(const std::filesystem::path& path, TopologicalMap& map) {
  const int nodes = static_cast<int>(map.nodes().size());
  const Signature next = nodes == 0 ? Signature{64, 64, {}} : map.nodes().back().views.back().signature;
  const auto update = fuzz::read_foreign("", [&] { return map.add(path.string(), next).node; });
  // A parameter out of range is found when it is used.
  if (update) check(map);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static fuzz::ForeignFile file(".map");
  const std::filesystem::path& path = file.hold(data, size);
  auto stored = fuzz::read_foreign(path, [&] { return MapStore(path).load(); });
  check_and_recover(path, stored.has_value());
  if (!stored) return 0;
  check(stored->map);
  const StoredMap again = saved_and_loaded(path, *stored);
  demand(again.frontend == stored->frontend && same(again.map, stored->map),
         "a map is the same when saved and loaded");
  const std::string once = content_of(path);
  saved_and_loaded(path, again);
  demand(content_of(path) == once, "its file is the same too, configuration and all");
  for (const std::string_view format : export_formats()) {
    std::ostringstream out;
    export_map(stored->map, format, out, {poses_for(stored->map), false, "images"});
  }
  continue_map(path, stored->map);
  return 0;
}
