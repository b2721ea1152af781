// Precision and recall as a JSON object: part of what `sailmap eval --json` writes.
#pragma once

#include <nlohmann/json.hpp>

#include "sailmap/evaluation.hpp"

namespace sailmap {

nlohmann::ordered_json to_json(const Evaluation& evaluation);

// Throws Error, or nlohmann's exception, when something is missing, of the wrong kind, out of range or
// contradicts the rest.
Evaluation evaluation_from_json(const nlohmann::ordered_json& json);

}  // namespace sailmap
