// What `run` prints: lines for people or lines of JSON.
#pragma once

#include <string>

#include "sailmap/topological_map.hpp"

namespace sailmap::app {

struct RunCounts {
  int images = 0;  // used in this run
  int loops = 0;   // accepted detections among them
  int skipped = 0;
  double seconds = 0;
};

// `image` is at the best node of `detection`; `event` and `words` name what that is: a loop closure, or where
// a robot is that only looks.
void print_place(const TopologicalMap& map, int image, const std::string& name, const Detection& detection,
                 const char* event, const char* words, bool json);

void print_run_summary(const RunCounts& counts, const TopologicalMap& map, const std::string& path,
                       bool json);

}  // namespace sailmap::app
