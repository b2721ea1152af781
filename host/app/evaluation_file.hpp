// What `sailmap eval --json` says of one data set, read back.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sailmap/evaluation.hpp"

namespace sailmap::app {

struct EvaluationFile {
  std::string method;
  nlohmann::ordered_json config;  // all parameters, with "frontend" (null for methods on words)
  bool traverses = false;         // two of them, not one sequence
  int queries = 0;
  int queries_with_match = 0;
  std::vector<CurvePoint> curve;  // falling threshold; precision and recall within 0 and 1
};

// Throws Error when something is missing, of the wrong kind or out of range.
EvaluationFile evaluation_from_json(const nlohmann::ordered_json& json);

// The same, naming the file.
EvaluationFile read_evaluation(const std::filesystem::path& path);

}  // namespace sailmap::app
