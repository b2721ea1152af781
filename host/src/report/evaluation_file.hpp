// What `sailmap eval --json` writes for the report beside its figures, and how the report reads it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sailmap/evaluation.hpp"
#include "subject.hpp"

namespace sailmap::report {

// Of two traverses `candidates` are the reference images, else empty: the queries themselves.
struct EvaluationNames {
  std::vector<std::string> queries;
  std::vector<std::string> candidates;
};

// {"names": {"queries", "candidates"}, "best": per query {"candidate", "score", "runner_up",
// "runner_up_score", "right"}, null where there is none, "similarity_matrix": see matrix_of; of two traverses
// its columns count on from the queries}. The runner-up is at least `same_place` candidates away.
nlohmann::ordered_json evaluation_details(const Plane<float>& scores, const GroundTruth& truth,
                                          const EvaluationNames& names, int same_place);

// A file as it was read.
struct EvaluationFile {
  Subject subject;
  std::string method;
  nlohmann::ordered_json evaluation;  // as evaluation_of
  nlohmann::ordered_json history;     // {"best", "score"}: per query
  nlohmann::ordered_json matrix;      // as matrix_of, or null
  nlohmann::ordered_json parameters;  // as the file has them
  int queries = 0;
  int candidates = 0;  // of another traverse; 0: the queries themselves
  double images_per_second = 0;
  std::vector<std::string> problems;
};

// Throws Error, naming the file, when it is not what `eval --json` writes.
EvaluationFile read_evaluation_file(const std::filesystem::path& path);

// The figures and the curve (at most 500 points of it) as the page reads them.
nlohmann::ordered_json evaluation_of(const Evaluation& evaluation);

}  // namespace sailmap::report
