// Configurations as JSON: stored in map files, written beside results, compared when a map is extended.
#pragma once

#include <nlohmann/json.hpp>

#include "sailmap/topological_map.hpp"

namespace sailmap {

nlohmann::ordered_json to_json(const MapConfig& config);
// Throws nlohmann::json::exception or Error when a key is missing or of the wrong kind.
MapConfig map_config_from_json(const nlohmann::ordered_json& json);

nlohmann::ordered_json to_json(const Signature& signature);
Signature signature_from_json(const nlohmann::ordered_json& json);

nlohmann::ordered_json to_json(const Detection& detection);
Detection detection_from_json(const nlohmann::ordered_json& json);

std::string_view name(Inhibition inhibition);
Inhibition inhibition_from_name(std::string_view text);  // throws Error
std::string_view name(DescriptorKind kind);
DescriptorKind descriptor_kind_from_name(std::string_view text);  // throws Error
std::string_view name(SignatureMaker maker);
SignatureMaker signature_maker_from_name(std::string_view text);  // throws Error

}  // namespace sailmap
