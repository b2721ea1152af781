#include "experiment_options.hpp"

#include <map>

#include "commands.hpp"

namespace sailmap::app {
namespace {

void check(const CLI::App& command, const Experiment& experiment) {
  const DataSet& data = experiment.data;
  if (data.source.empty() == data.reference.empty() || data.reference.empty() != data.query.empty()) {
    throw UsageError(command.get_name() + " takes either SOURCE or both --reference and --query");
  }
  if (data.traverses() && command.get_option("--exclude-recent")->count() > 0) {
    throw UsageError("--exclude-recent is for one sequence; two traverses are compared whole");
  }
  if ((command.get_option("--side")->count() > 0) != data.selection.oxford) {
    throw UsageError("--layout oxford and --side left|right go together");
  }
  if (data.selection.oxford && data.traverses()) throw UsageError("--layout oxford is for one sequence");
  if (!data.reference_poses.empty() && !data.traverses()) {
    throw UsageError("--reference-poses goes with --reference and --query");
  }
  if (experiment.recogniser.on_words() == experiment.recogniser.vocabulary.empty()) {
    throw UsageError("--vocabulary and the methods fabmap and bow go together");
  }
  if (data.ground_truth.empty()) throw UsageError(command.get_name() + " needs --ground-truth");
}

void add_ground_truth_options(CLI::App& command, Experiment& experiment) {
  constexpr const char* group = "Ground truth";
  DataSet& data = experiment.data;
  command
      .add_option("--ground-truth", data.ground_truth,
                  "Matches (`query: candidate ...` a line, or a MATLAB .mat matrix) or poses (KITTI, TUM, "
                  "CSV with x,y or lat,lon); of the queries, when there are two traverses")
      ->type_name("FILE")
      ->group(group);
  command
      .add_option("--radius", data.radius, "For poses: metres within which two images show the same place")
      ->check(CLI::PositiveNumber.description(""))
      ->group(group);
  command
      .add_option("--reference-poses", data.reference_poses,
                  "Two traverses: the poses of the reference images")
      ->type_name("FILE")
      ->group(group);
  one_of(command.add_option(
             "--layout", experiment.layout,
             "oxford: left and right images interleave, as in the FAB-MAP data sets; needs --side"),
         {"plain", "oxford"})
      ->capture_default_str()
      ->group(group);
  command.add_option("--side", data.selection.side, "Which images of an oxford layout to take")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, Side>{{"left", Side::left}, {"right", Side::right}})
              .description(""))
      ->type_name("left|right")
      ->group(group);
}

Measurement measure_words(const DataSet& data, const Recogniser& recogniser, GroundTruth& truth) {
  const fabmap::Vocabulary vocabulary = fabmap::read_vocabulary(recogniser.vocabulary);
  truth = read_truth(data);
  return measure(data, truth, describe(data, vocabulary), recogniser, vocabulary);
}

Measurement measure_signatures(const DataSet& data, const Recogniser& recogniser, GroundTruth& truth) {
  truth = read_truth(data);
  return measure(data, truth, describe(data, recogniser.frontend, recogniser.config.regions), recogniser);
}

}  // namespace

void add_data_options(CLI::App& command, Experiment& experiment) {
  DataSet& data = experiment.data;
  command.add_option("SOURCE", data.source,
                     "One sequence: folder, glob in quotes, list file (.txt) or video");
  command.add_option("--reference", data.reference, "Two traverses: where the map images are")
      ->type_name("DIR");
  command.add_option("--query", data.query, "Two traverses: where the query images are")->type_name("DIR");
  add_ground_truth_options(command, experiment);
}

OptionKeys add_recognition_options(CLI::App& command, Experiment& experiment) {
  Recogniser& recogniser = experiment.recogniser;
  MapConfig& config = recogniser.config;
  OptionKeys keys;
  keys["/exclude_recent"] = command
                                .add_option("--exclude-recent", experiment.data.exclude_recent,
                                            "Do not compare an image with so many just before it")
                                ->check(CLI::NonNegativeNumber.description(""))
                                ->capture_default_str();
  add_frontend_option(command, recogniser.frontend);
  keys["/frontend"] = command.get_option("--frontend");
  keys["/match/method"] = add_recogniser_options(command, recogniser).front();
  keys.merge(add_constraint_options(command, config.match));
  keys["/temporal"] = add_temporal_option(command, config.temporal)->capture_default_str();
  keys.merge(add_region_options(command, config.regions));
  return keys;
}

void settle_experiment(const CLI::App& command, Experiment& experiment, bool threshold_given) {
  experiment.data.selection.oxford = experiment.layout == "oxford";
  settle(experiment.recogniser, threshold_given);
  check(command, experiment);
}

Measurement measure(const Experiment& experiment, GroundTruth& truth) {
  return experiment.recogniser.on_words() ? measure_words(experiment.data, experiment.recogniser, truth)
                                          : measure_signatures(experiment.data, experiment.recogniser, truth);
}

}  // namespace sailmap::app
