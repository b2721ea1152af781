#include "evaluation_json.hpp"

#include <string>

#include "io/json_numbers.hpp"
#include "sailmap/error.hpp"

namespace sailmap {
namespace {

using nlohmann::ordered_json;

double part_of_one(const ordered_json& json) {
  const double value = json.get<double>();
  if (!(value >= 0 && value <= 1)) throw Error("not within 0 and 1: " + json.dump());
  return value;
}

// How many of so many.
int count(const ordered_json& json, int most) {
  const int value = io::whole_number(json);
  if (value < 0 || value > most) {
    throw Error("not within 0 and " + std::to_string(most) + ": " + json.dump());
  }
  return value;
}

int positive(const ordered_json& json) {
  const int value = io::whole_number(json);
  if (value < 1) throw Error("not above 0: " + json.dump());
  return value;
}

ordered_json to_json(const FixedThreshold& fixed) {
  return {{"threshold", fixed.threshold},
          {"detections", fixed.detections},
          {"right", fixed.right},
          {"precision", fixed.precision},
          {"recall", fixed.recall}};
}

FixedThreshold fixed_from(const ordered_json& json, int queries) {
  FixedThreshold fixed;
  fixed.threshold = json.at("threshold").get<double>();
  fixed.detections = count(json.at("detections"), queries);
  fixed.right = count(json.at("right"), fixed.detections);
  fixed.precision = part_of_one(json.at("precision"));
  fixed.recall = part_of_one(json.at("recall"));
  return fixed;
}

ordered_json to_json(const std::vector<CurvePoint>& curve) {
  ordered_json json = ordered_json::array();
  for (const CurvePoint& point : curve) {
    json.push_back(
        {{"threshold", point.threshold}, {"precision", point.precision}, {"recall", point.recall}});
  }
  return json;
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

ordered_json to_json(const Evaluation& e) {
  ordered_json recall_at;
  for (std::size_t k = 0; k < recall_ranks.size(); ++k) {
    recall_at[std::to_string(recall_ranks[k])] = e.recall_at[k];
  }
  return {{"queries", e.queries},
          {"queries_with_match", e.queries_with_match},
          {"fixed_threshold", to_json(e.fixed)},
          {"average_precision", e.average_precision},
          {"recall_at_100_precision", e.recall_at_100},
          {"recall_at_95_precision", e.recall_at_95},
          {"best_f1", e.best_f1},
          {"best_f1_threshold", e.best_f1_threshold},
          {"recall_at", std::move(recall_at)},
          {"curve", to_json(e.curve)}};
}

Evaluation evaluation_from_json(const ordered_json& json) {
  Evaluation e;
  e.queries = positive(json.at("queries"));
  e.queries_with_match = positive(json.at("queries_with_match"));
  if (e.queries_with_match > e.queries) throw Error("more queries with a match than queries");
  e.fixed = fixed_from(json.at("fixed_threshold"), e.queries);
  e.average_precision = part_of_one(json.at("average_precision"));
  e.recall_at_100 = part_of_one(json.at("recall_at_100_precision"));
  e.recall_at_95 = part_of_one(json.at("recall_at_95_precision"));
  e.best_f1 = part_of_one(json.at("best_f1"));
  e.best_f1_threshold = json.at("best_f1_threshold").get<double>();
  for (std::size_t k = 0; k < recall_ranks.size(); ++k) {
    e.recall_at[k] = part_of_one(json.at("recall_at").at(std::to_string(recall_ranks[k])));
  }
  e.curve = curve_from(json.at("curve"));
  return e;
}

}  // namespace sailmap
