#include "evaluation_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "evaluate/evaluation_json.hpp"
#include "io/file_reading.hpp"
#include "io/json_numbers.hpp"
#include "map/config_json.hpp"
#include "matrix.hpp"
#include "sailmap/error.hpp"

namespace sailmap::report {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t curve_points = 500;

Ranking rank_row(const Plane<float>& scores, int query, int same_place) {
  std::vector<Candidate> candidates;
  for (int c = 0; c < scores.width(); ++c) {
    if (!std::isnan(scores(c, query))) candidates.push_back({c, static_cast<double>(scores(c, query))});
  }
  return rank(candidates, same_place);
}

// Candidate and score, or null.
void append(ordered_json& candidates, ordered_json& scores, const Candidate& candidate) {
  candidates.push_back(candidate.node < 0 ? ordered_json(nullptr) : ordered_json(candidate.node));
  scores.push_back(candidate.node < 0 ? ordered_json(nullptr)
                                      : ordered_json(shortened(candidate.similarity)));
}

// [threshold, precision, recall, ...], thinned evenly; the last point stays.
ordered_json thinned(const std::vector<CurvePoint>& curve) {
  ordered_json out = ordered_json::array();
  const std::size_t count = std::min(curve.size(), curve_points);
  for (std::size_t k = 0; k < count; ++k) {
    const CurvePoint& point = curve[count == 1 ? 0 : k * (curve.size() - 1) / (count - 1)];
    for (const double value : {point.threshold, point.precision, point.recall})
      out.push_back(shortened(value));
  }
  return out;
}

std::string title_of(const ordered_json& json) {
  if (json.contains("source")) return json.at("source").get<std::string>();
  return json.at("query").get<std::string>() + " in " + json.at("reference").get<std::string>();
}

Candidate candidate_at(const ordered_json& best, const char* which, const char* score, std::size_t query,
                       int candidates) {
  const ordered_json& number = best.at(which).at(query);
  if (number.is_null()) return {};
  const Candidate out{io::whole_number(number), best.at(score).at(query).get<double>()};
  if (out.node < 0 || out.node >= candidates)
    throw Error(fmt::format("query {} has no such {}", query, which));
  return out;
}

// Names, loops, best candidates.
void read_details(const ordered_json& json, EvaluationFile& out) {
  out.subject.names = json.at("names").at("queries").get<std::vector<std::string>>();
  const auto references = json.at("names").at("candidates").get<std::vector<std::string>>();
  out.subject.names.insert(out.subject.names.end(), references.begin(), references.end());
  out.candidates = static_cast<int>(references.size());
  if (static_cast<int>(out.subject.names.size()) != out.queries + out.candidates) {
    throw Error("as many names as images are missing");
  }
  const int first = references.empty() ? 0 : out.queries;
  const ordered_json& best = json.at("best");
  ordered_json images = ordered_json::array();
  ordered_json scores = ordered_json::array();
  const int among = references.empty() ? out.queries : out.candidates;
  for (int q = 0; q < out.queries; ++q) {
    const auto query = static_cast<std::size_t>(q);
    Candidate found = candidate_at(best, "candidate", "score", query, among);
    Candidate rival = candidate_at(best, "runner_up", "runner_up_score", query, among);
    if (found.node >= 0) found.node += first;
    if (rival.node >= 0) rival.node += first;
    append(images, scores, found);
    if (found.node < 0 || !(found.similarity > out.subject.threshold)) continue;
    out.subject.loops.push_back({.image = q,
                                 .views = {found.node},
                                 .score = found.similarity,
                                 .rival = rival.node,
                                 .rival_score = rival.similarity,
                                 .matches = {},
                                 .right = best.at("right").at(query).get<bool>()});
  }
  out.history = {{"best", std::move(images)}, {"score", std::move(scores)}};
  out.matrix = json.at("similarity_matrix");
}

EvaluationFile read(const ordered_json& json) {
  EvaluationFile out;
  if (json.contains("data_sets")) {
    throw Error("a table of several data sets; a report is of one: run `sailmap eval` without --table");
  }
  const Evaluation evaluation = evaluation_from_json(json);
  out.evaluation = evaluation_of(evaluation);
  out.subject.title = title_of(json);
  json.at("method").get_to(out.method);
  out.subject.threshold = evaluation.fixed.threshold;
  out.parameters = json.at("config");
  out.queries = io::whole_number(json.at("images"));
  json.at("images_per_second").get_to(out.images_per_second);
  if (!json.at("frontend").is_null()) {
    json.at("frontend").get_to(out.subject.frontend);
    out.subject.config = map_config_from_json(out.parameters);
  }
  if (json.contains("names")) {
    read_details(json, out);
  } else {
    out.problems.emplace_back(
        "The file was written by an older sailmap: it names no images, so that no loops are shown. Run "
        "sailmap eval again.");
  }
  return out;
}

}  // namespace

ordered_json evaluation_of(const Evaluation& e) {
  return {{"queries", e.queries},
          {"queries_with_match", e.queries_with_match},
          {"average_precision", e.average_precision},
          {"recall_at_100", e.recall_at_100},
          {"recall_at_95", e.recall_at_95},
          {"best_f1", e.best_f1},
          {"best_f1_threshold", e.best_f1_threshold},
          {"fixed",
           {{"threshold", e.fixed.threshold},
            {"detections", e.fixed.detections},
            {"right", e.fixed.right},
            {"precision", e.fixed.precision},
            {"recall", e.fixed.recall}}},
          {"curve", thinned(e.curve)}};
}

ordered_json evaluation_details(const Plane<float>& scores, const GroundTruth& truth,
                                const EvaluationNames& names, int same_place) {
  ordered_json best;
  for (const char* key : {"candidate", "score", "runner_up", "runner_up_score", "right"}) {
    best[key] = ordered_json::array();
  }
  for (int q = 0; q < scores.height(); ++q) {
    const Ranking ranking = rank_row(scores, q, same_place);
    append(best["candidate"], best["score"], ranking.best);
    append(best["runner_up"], best["runner_up_score"], ranking.runner_up);
    best["right"].push_back(
        std::ranges::binary_search(truth.matches[static_cast<std::size_t>(q)], ranking.best.node));
  }
  // The whole matrix, its blocks by their highest score: nothing is sampled.
  Similarities whole;
  whole.scores = scores;
  whole.rows.resize(static_cast<std::size_t>(scores.height()));
  whole.columns.resize(static_cast<std::size_t>(scores.width()));
  std::iota(whole.rows.begin(), whole.rows.end(), 0);
  std::iota(whole.columns.begin(), whole.columns.end(), 0);
  ordered_json matrix = matrix_of(whole, truth);
  if (!names.candidates.empty()) {
    for (ordered_json& column : matrix["columns"]) column = column.get<int>() + scores.height();
  }
  return {{"names", {{"queries", names.queries}, {"candidates", names.candidates}}},
          {"best", std::move(best)},
          {"similarity_matrix", std::move(matrix)}};
}

EvaluationFile read_evaluation_file(const std::filesystem::path& path) {
  std::ifstream in = io::open_for_reading(path);
  try {
    return read(ordered_json::parse(in));
  } catch (const ordered_json::exception& fault) {
    throw Error(path.string() + ": not what `sailmap eval --json` writes, or damaged: " + fault.what());
  } catch (const Error& fault) {
    throw Error(path.string() + ": " + fault.what());
  }
}

}  // namespace sailmap::report
