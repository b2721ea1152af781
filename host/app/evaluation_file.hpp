// What `sailmap eval --json` says of one data set, read back.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "sailmap/evaluation.hpp"

namespace sailmap::app {

struct EvaluationFile {
  std::string method;
  nlohmann::ordered_json config;  // all parameters, with "frontend" (null for methods on words)
  bool traverses = false;         // two of them, not one sequence
  Evaluation evaluation;
};

// Throws Error when something is missing, of the wrong kind or out of range.
EvaluationFile evaluation_file_from_json(const nlohmann::ordered_json& json);

// The same, naming the file.
EvaluationFile read_evaluation(const std::filesystem::path& path);

}  // namespace sailmap::app
