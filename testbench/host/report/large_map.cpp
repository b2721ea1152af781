// Writes a map of many places without images: large_map OUT.map PLACES. The camera goes round and round a
// circuit; every second lap it is back at places it knows. Names are those of files that do not exist.
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "sailmap/map_store.hpp"
#include "sailmap/topological_map.hpp"

namespace {

using namespace sailmap;

constexpr int per_lap = 500;

// One region: there is nothing to compare, only to carry.
Signature signature_of(int image) {
  Signature signature{640, 480, {}};
  signature.regions.push_back({static_cast<std::int16_t>(image % 640), 240, 1.0F, {1.0F}});
  return signature;
}

Detection detection_of(int image, int nodes) {
  Detection detection;
  const bool back = (image / per_lap) % 2 == 1;
  detection.reason = image == 0 ? Reason::no_nodes : back ? Reason::accepted : Reason::below_threshold;
  if (image == 0) return detection;
  const int node = back ? nodes - per_lap + image % per_lap : nodes / 2;
  const double strength = 4 + 3 * std::sin(image * 0.13);
  detection.best = {node, back ? 3.01 + strength : 0.3 * strength};
  if (nodes > 200) detection.runner_up = {nodes / 3, 0.2 * strength};
  if (back) detection.matches = {{0, 0, 0.1}};
  return detection;
}

TopologicalMap make_map(int places) {
  MapConfig config;
  config.detection.threshold = default_threshold(config.match.method);
  std::vector<Node> nodes;
  std::vector<Edge> edges;
  std::vector<Update> history;
  int active = -1;
  for (int image = 0; static_cast<int>(nodes.size()) < places || (image / per_lap) % 2 == 1; ++image) {
    const int known = static_cast<int>(nodes.size());
    Update update{image, "nowhere/" + std::to_string(image) + ".png", known, true,
                  detection_of(image, known)};
    if (update.detection.accepted()) {
      update.node = update.detection.best.node;
      update.new_node = false;
      // From the lap's end back to its start, and along the way that is known.
      if (active != update.node) edges.push_back({active, update.node, EdgeKind::loop});
    } else {
      nodes.push_back({known, {{image, update.name, signature_of(image)}}});
      if (active >= 0) edges.push_back({active, known, EdgeKind::path});
    }
    active = update.node;
    history.push_back(std::move(update));
  }
  return {config, std::move(nodes), std::move(edges), std::move(history), active};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "large_map OUT.map PLACES\n";
    return 2;
  }
  try {
    sailmap::MapStore(argv[1]).save(make_map(std::atoi(argv[2])), "fixed");
  } catch (const std::exception& fault) {
    std::cerr << fault.what() << '\n';
    return 1;
  }
  return 0;
}
