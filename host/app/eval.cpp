// sailmap eval: precision and recall on a sequence, or on two traverses, with ground truth (spec 12); or a
// table of several data sets and methods.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "commands.hpp"
#include "measurement.hpp"
#include "options.hpp"
#include "sailmap/figures.hpp"
#include "sailmap/file.hpp"
#include "sailmap/npy.hpp"

namespace sailmap::app {
namespace {

namespace fs = std::filesystem;

struct Options {
  DataSet data;
  std::string layout = "plain";
  Recogniser recogniser;
  fs::path scores;
  fs::path json;
  fs::path plot;
};

void check(const Options& options, bool side_given, bool exclude_given) {
  const DataSet& data = options.data;
  if (data.source.empty() == data.reference.empty() || data.reference.empty() != data.query.empty()) {
    throw UsageError("eval takes either SOURCE or both --reference and --query");
  }
  if (data.traverses() && exclude_given) {
    throw UsageError("--exclude-recent is for one sequence; two traverses are compared whole");
  }
  if (side_given != data.selection.oxford) {
    throw UsageError("--layout oxford and --side left|right go together");
  }
  if (data.selection.oxford && data.traverses()) throw UsageError("--layout oxford is for one sequence");
  if (!data.reference_poses.empty() && !data.traverses()) {
    throw UsageError("--reference-poses goes with --reference and --query");
  }
  if (options.recogniser.fabmap() == options.recogniser.vocabulary.empty()) {
    throw UsageError("--method fabmap and --vocabulary go together");
  }
}

Measurement measure_fabmap(const DataSet& data, const Recogniser& recogniser, GroundTruth& truth) {
  const fabmap::Vocabulary vocabulary = fabmap::read_vocabulary(recogniser.vocabulary);
  truth = read_truth(data);
  return measure(data, truth, describe(data, vocabulary), recogniser, vocabulary);
}

// The ground truth first: a wrong one should not cost the user the wait for the images.
Measurement measure_signatures(const DataSet& data, const Recogniser& recogniser, GroundTruth& truth) {
  truth = read_truth(data);
  return measure(data, truth, describe(data, recogniser.frontend, recogniser.config.regions), recogniser);
}

void eval(const Options& options) {
  GroundTruth truth;
  const Measurement result = options.recogniser.fabmap()
                                 ? measure_fabmap(options.data, options.recogniser, truth)
                                 : measure_signatures(options.data, options.recogniser, truth);
  if (!options.scores.empty()) write_npy(options.scores, result.scores);
  if (!options.plot.empty()) {
    write_evaluation_plot(options.plot, result.evaluation, result.scores, truth, title_of(result));
  }
  if (!options.json.empty()) {
    write_file(options.json, [&](std::ostream& out) { out << to_json(result).dump(2) << '\n'; });
  }
  print(result);
}

void add_ground_truth_options(CLI::App& command, Options& options) {
  constexpr const char* group = "Ground truth";
  DataSet& data = options.data;
  command
      .add_option("--ground-truth", data.ground_truth,
                  "Matches (`query: candidate ...` a line, or a MATLAB .mat matrix) or poses (KITTI, TUM, "
                  "CSV with x,y or lat,lon); of the queries, when there are two traverses")
      ->required()
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
  command
      .add_option("--layout", options.layout,
                  "oxford: left and right images interleave, as in the FAB-MAP data sets; needs --side")
      ->check(CLI::IsMember({"plain", "oxford"}).description(""))
      ->capture_default_str()
      ->type_name("plain|oxford")
      ->group(group);
  command.add_option("--side", data.selection.side, "Which images of an oxford layout to take")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, Side>{{"left", Side::left}, {"right", Side::right}})
              .description(""))
      ->type_name("left|right")
      ->group(group);
}

void add_result_options(CLI::App& command, Options& options) {
  constexpr const char* group = "Results";
  command
      .add_option("--scores", options.scores,
                  "Similarities: float32, queries x candidates, NaN if not admissible")
      ->type_name("OUT.npy")
      ->group(group);
  command.add_option("--json", options.json, "All figures, the curve and the parameters")
      ->type_name("OUT.json")
      ->group(group);
  command.add_option("--plot", options.plot, "Precision-recall curve and similarity matrix")
      ->type_name("OUT.svg")
      ->group(group);
}

}  // namespace

void add_eval(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("eval", "Measure precision and recall against ground truth");
  DataSet& data = options->data;
  command->add_option("SOURCE", data.source,
                      "One sequence: folder, glob in quotes, list file (.txt) or video");
  command->add_option("--reference", data.reference, "Two traverses: where the map images are")
      ->type_name("DIR");
  command->add_option("--query", data.query, "Two traverses: where the query images are")->type_name("DIR");
  add_ground_truth_options(*command, *options);
  add_result_options(*command, *options);
  const CLI::Option* exclude = command
                                   ->add_option("--exclude-recent", data.exclude_recent,
                                                "Do not compare an image with so many just before it")
                                   ->check(CLI::NonNegativeNumber.description(""))
                                   ->capture_default_str();
  Recogniser& recogniser = options->recogniser;
  MapConfig& config = recogniser.config;
  add_frontend_option(*command, recogniser.frontend);
  add_threshold_option(*command, config.detection.threshold,
                       fmt::format(", {:g} for fabmap (log-odds: p = 0.99)", fabmap::default_threshold));
  add_recogniser_options(*command, recogniser);
  add_constraint_options(*command, config.match);
  add_temporal_option(*command, config.temporal)->capture_default_str();
  add_region_options(*command, config.regions);
  const CLI::Option* side = command->get_option("--side");
  const CLI::Option* threshold = command->get_option("--threshold");
  command->callback([options, side, exclude, threshold] {
    options->data.selection.oxford = options->layout == "oxford";
    settle(options->recogniser, threshold->count() > 0);
    check(*options, side->count() > 0, exclude->count() > 0);
    eval(*options);
  });
}

}  // namespace sailmap::app
