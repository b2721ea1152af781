// Precision and recall of one recogniser on one data set, for people and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "experiment.hpp"

namespace sailmap::app {

struct Measurement {
  DataSet data;
  Recogniser recogniser;
  nlohmann::ordered_json config;  // all parameters
  int images = 0;                 // queries
  int candidates = 0;
  Plane<float> scores;
  double images_per_second = 0;  // described: signatures or words
  Evaluation evaluation;
};

// Throws Error when no query has an admissible true match.
Measurement measure(const DataSet& data, const GroundTruth& truth, const Views<Signature>& views,
                    const Recogniser& recogniser);
Measurement measure(const DataSet& data, const GroundTruth& truth, const Views<fabmap::Histogram>& views,
                    const Recogniser& recogniser, const fabmap::Vocabulary& vocabulary);

// Data set, method, temporal filter: in one line.
std::string title_of(const Measurement& measurement);

nlohmann::ordered_json to_json(const Measurement& measurement);

// On standard output.
void print(const Measurement& measurement);

}  // namespace sailmap::app
