// Which detections of a map a user asks for.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "sailmap/topological_map.hpp"

namespace sailmap::app {

struct LoopChoice {
  double least = -std::numeric_limits<double>::infinity();  // similarity
  double most = std::numeric_limits<double>::infinity();
  int first_image = 0;
  int last_image = std::numeric_limits<int>::max();
  int node = -1;                    // the best one's; -1: any
  std::string reason = "accepted";  // one of loop_reasons()
  std::string sort = "image";       // one of loop_orders()
  int limit = 0;                    // 0: none
};

// The names of all reasons, and "all".
std::vector<std::string> loop_reasons();
// image, similarity, doubt.
std::vector<std::string> loop_orders();

// A detection that was compared with no node passes only when neither similarity nor node was asked for.
std::vector<const Update*> chosen_loops(const TopologicalMap& map, const LoopChoice& choice);

// The name of the image that made the node.
const std::string& name_of_node(const TopologicalMap& map, int node);

}  // namespace sailmap::app
