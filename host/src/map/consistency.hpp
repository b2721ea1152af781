// Whether the parts of a map that was stored fit together.
#pragma once

#include <vector>

#include "sailmap/topological_map.hpp"

namespace sailmap {

// Throws Error with the first contradiction: numbers that are not those of their places, nodes without images
// or with images that were never added or of different size, edges and images that lead to no node, sessions
// that do not rise, an active node that is not the last image's.
void check_consistency(const std::vector<Node>& nodes, const std::vector<Edge>& edges,
                       const std::vector<Update>& history, int active, const std::vector<int>& sessions);

}  // namespace sailmap
