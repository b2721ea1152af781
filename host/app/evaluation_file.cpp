#include "evaluation_file.hpp"

#include "io/file_reading.hpp"
#include "io/json_numbers.hpp"
#include "sailmap/error.hpp"

namespace sailmap::app {
namespace {

using nlohmann::ordered_json;

double part_of_one(const ordered_json& json) {
  const double value = json.get<double>();
  if (!(value >= 0 && value <= 1)) throw Error("not within 0 and 1: " + json.dump());
  return value;
}

int positive(const ordered_json& json) {
  const int value = io::whole_number(json);
  if (value < 1) throw Error("not above 0: " + json.dump());
  return value;
}

std::vector<CurvePoint> curve_from(const ordered_json& json) {
  std::vector<CurvePoint> curve;
  for (const ordered_json& point : json) {
    curve.push_back({point.at("threshold").get<double>(), part_of_one(point.at("precision")),
                     part_of_one(point.at("recall"))});
    if (curve.size() > 1 && curve.back().threshold >= curve[curve.size() - 2].threshold) {
      throw Error("the thresholds of the curve do not fall");
    }
  }
  return curve;
}

}  // namespace

EvaluationFile evaluation_from_json(const ordered_json& json) {
  EvaluationFile out;
  out.method = json.at("method").get<std::string>();
  out.config = json.at("config");
  if (!out.config.is_object()) throw Error("config is no object");
  out.config["frontend"] = json.at("frontend");
  out.traverses = json.contains("reference");
  out.queries = positive(json.at("queries"));
  out.queries_with_match = positive(json.at("queries_with_match"));
  out.curve = curve_from(json.at("curve"));
  return out;
}

EvaluationFile read_evaluation(const std::filesystem::path& path) {
  std::ifstream in = io::open_for_reading(path);
  try {
    const ordered_json json = ordered_json::parse(in);
    if (!json.is_object() || !json.contains("curve"))
      throw Error("no curve: not an evaluation of one data set");
    return evaluation_from_json(json);
  } catch (const ordered_json::exception& fault) {
    throw Error(path.string() + ": not what `sailmap eval --json` writes: " + fault.what());
  } catch (const Error& fault) {
    throw Error(path.string() + ": " + fault.what());
  }
}

}  // namespace sailmap::app
