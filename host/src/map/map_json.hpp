// A whole map as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "sailmap/topological_map.hpp"

namespace sailmap {

nlohmann::ordered_json to_json(const TopologicalMap& map);
// Throws nlohmann::json::exception or Error when something is missing, of the wrong kind, or contradictory.
TopologicalMap map_from_json(const nlohmann::ordered_json& json);

}  // namespace sailmap
