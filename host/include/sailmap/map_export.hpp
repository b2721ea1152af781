// A map in formats that other programs read.
#pragma once

#include <ostream>
#include <string_view>
#include <vector>

#include "sailmap/topological_map.hpp"

namespace sailmap {

// dot, graphml, g2o, csv, json.
std::vector<std::string_view> export_formats();

// Throws Error for an unknown format.
void export_map(const TopologicalMap& map, std::string_view format, std::ostream& out);

}  // namespace sailmap
