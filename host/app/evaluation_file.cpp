#include "evaluation_file.hpp"

#include "evaluate/evaluation_json.hpp"
#include "io/file_reading.hpp"
#include "sailmap/error.hpp"

namespace sailmap::app {

using nlohmann::ordered_json;

EvaluationFile evaluation_file_from_json(const ordered_json& json) {
  EvaluationFile out;
  out.method = json.at("method").get<std::string>();
  out.config = json.at("config");
  if (!out.config.is_object()) throw Error("config is no object");
  out.config["frontend"] = json.at("frontend");
  out.traverses = json.contains("reference");
  out.evaluation = evaluation_from_json(json);
  return out;
}

EvaluationFile read_evaluation(const std::filesystem::path& path) {
  std::ifstream in = io::open_for_reading(path);
  try {
    const ordered_json json = ordered_json::parse(in);
    if (!json.is_object() || !json.contains("curve"))
      throw Error("no curve: not an evaluation of one data set");
    return evaluation_file_from_json(json);
  } catch (const ordered_json::exception& fault) {
    throw Error(path.string() + ": not what `sailmap eval --json` writes: " + fault.what());
  } catch (const Error& fault) {
    throw Error(path.string() + ": " + fault.what());
  }
}

}  // namespace sailmap::app
