// The map as a drawing: where its nodes lie, and what joins them.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "sailmap/ground_truth.hpp"
#include "sailmap/topological_map.hpp"

namespace sailmap::report {

// [x of node 0, y of node 0, ...], y upwards, laid out by graphviz; units mean nothing. Takes seconds for
// 20 000 nodes; calls take turns. Throws Error when graphviz fails.
std::vector<double> lay_out(int nodes, const std::vector<Edge>& edges);

// The same of known positions: a node is where its first image was taken.
std::vector<double> node_positions(const TopologicalMap& map, const std::vector<Pose>& positions);

// {"nodes", "images": first image of each node, "views": images of each node (sparse maps alone), "paths":
// [from, to, ...], "active"}; the page finds the loops' lines in the history.
nlohmann::ordered_json graph_of(const TopologicalMap& map);

// Numbers on a grid of a 10 000th of the larger side.
nlohmann::ordered_json rounded_positions(const std::vector<double>& positions);

}  // namespace sailmap::report
