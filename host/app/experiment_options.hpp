// The options that say what is measured: a data set, its ground truth, and how places are recognised in it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "measurement.hpp"
#include "options.hpp"

namespace sailmap::app {

struct Experiment {
  DataSet data;
  std::string layout = "plain";
  Recogniser recogniser;
};

// SOURCE, --reference, --query and what there is to say of ground truth.
void add_data_options(CLI::App& command, Experiment& experiment);
// Front end, method, vocabulary, constraints, temporal filter, regions: by the keys of the configuration
// ("/frontend" and "/exclude_recent" too).
OptionKeys add_recognition_options(CLI::App& command, Experiment& experiment);

// When all is parsed. Throws UsageError for options that contradict each other.
void settle_experiment(const CLI::App& command, Experiment& experiment, bool threshold_given);

// The ground truth is read first: a wrong one should not cost the user the wait for the images.
Measurement measure(const Experiment& experiment, GroundTruth& truth);

}  // namespace sailmap::app
