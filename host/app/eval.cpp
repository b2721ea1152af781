// sailmap eval: precision and recall on a sequence, or on two traverses, with ground truth (spec 12).
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "commands.hpp"
#include "describe_source.hpp"
#include "map/config_json.hpp"
#include "options.hpp"
#include "sailmap/error.hpp"
#include "sailmap/evaluation.hpp"
#include "sailmap/figures.hpp"
#include "sailmap/file.hpp"
#include "sailmap/npy.hpp"
#include "sailmap/temporal_filter.hpp"

namespace sailmap::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct Options {
  std::string source;
  std::string reference;
  std::string query;
  std::string ground_truth;
  std::string reference_poses;
  std::string layout = "plain";
  Side side = Side::left;
  double radius = 0;
  std::string frontend;
  fs::path scores;
  fs::path json;
  fs::path plot;
  MapConfig config;

  [[nodiscard]] bool traverses() const { return !reference.empty(); }
  [[nodiscard]] bool oxford() const { return layout == "oxford"; }
};

void check(const Options& options, bool side_given, bool exclude_given) {
  if (options.source.empty() == options.reference.empty() ||
      options.reference.empty() != options.query.empty()) {
    throw UsageError("eval takes either SOURCE or both --reference and --query");
  }
  if (options.traverses() && exclude_given) {
    throw UsageError("--exclude-recent is for one sequence; two traverses are compared whole");
  }
  if (side_given != options.oxford()) throw UsageError("--layout oxford and --side left|right go together");
  if (options.oxford() && options.traverses()) throw UsageError("--layout oxford is for one sequence");
  if (!options.reference_poses.empty() && !options.traverses()) {
    throw UsageError("--reference-poses goes with --reference and --query");
  }
}

// What the scores are made of, and their ground truth.
struct Experiment {
  Plane<float> scores;
  GroundTruth truth;
  double images_per_second = 0;
  std::string title;
};

Experiment experiment(const Options& options) {
  DescribeOptions describe{options.frontend, options.config.regions, options.oxford(), options.side};
  const std::string first = options.traverses() ? options.query : options.source;
  const SourceInfo info = inspect_source(first, describe);
  const SourceInfo other = options.traverses() ? inspect_source(options.reference, describe) : info;
  Experiment out;
  // The ground truth first: a wrong one should not cost the user the wait for the images.
  GroundTruthOptions truth;
  truth.queries = info.images;
  truth.candidates = other.images;
  truth.same_sequence = !options.traverses();
  truth.radius = options.radius;
  truth.oxford = options.oxford();
  truth.side = options.side;
  out.truth = options.reference_poses.empty()
                  ? read_ground_truth(options.ground_truth, truth)
                  : read_ground_truth(options.ground_truth, options.reference_poses, truth);
  const DescribedSource queries = describe_source(first, describe);
  out.images_per_second = queries.images_per_second;
  out.title = first;
  if (options.traverses()) {
    const DescribedSource references = describe_source(options.reference, describe);
    out.scores = score_traverses(queries.signatures, references.signatures, options.config.match);
    out.title += " in " + options.reference;
  } else {
    out.scores = score_sequence(queries.signatures, options.config.exclude_recent, options.config.match);
  }
  out.title += ", " + std::string(name(options.config.match.method));
  if (options.config.temporal > 1) {
    out.scores =
        filter_scores(out.scores, temporal_config(options.config.match.method, options.config.temporal));
    out.title += fmt::format(", temporal filter of {} images", options.config.temporal);
  }
  return out;
}

ordered_json to_json(const Evaluation& e, const Experiment& experiment, const Options& options) {
  ordered_json curve = ordered_json::array();
  for (const CurvePoint& point : e.curve) {
    curve.push_back(
        {{"threshold", point.threshold}, {"precision", point.precision}, {"recall", point.recall}});
  }
  ordered_json recall_at;
  for (std::size_t k = 0; k < recall_ranks.size(); ++k)
    recall_at[std::to_string(recall_ranks[k])] = e.recall_at[k];
  ordered_json json;
  if (options.traverses()) {
    json = {{"query", options.query}, {"reference", options.reference}};
  } else {
    json = {{"source", options.source}};
  }
  json.update({{"ground_truth", options.ground_truth},
               {"frontend", options.frontend},
               {"method", name(options.config.match.method)},
               {"config", to_json(options.config)},
               {"images", experiment.scores.height()},
               {"candidates", experiment.scores.width()},
               {"images_per_second", experiment.images_per_second},
               {"queries", e.queries},
               {"queries_with_match", e.queries_with_match},
               {"fixed_threshold",
                {{"threshold", e.fixed.threshold},
                 {"detections", e.fixed.detections},
                 {"right", e.fixed.right},
                 {"precision", e.fixed.precision},
                 {"recall", e.fixed.recall}}},
               {"average_precision", e.average_precision},
               {"recall_at_100_precision", e.recall_at_100},
               {"recall_at_95_precision", e.recall_at_95},
               {"best_f1", e.best_f1},
               {"best_f1_threshold", e.best_f1_threshold},
               {"recall_at", recall_at},
               {"curve", curve}});
  return json;
}

void print(const Evaluation& e, const Experiment& experiment, const Options& options) {
  fmt::print("{}\n", experiment.title);
  fmt::print(
      "{} queries, {} with a true match among their candidates; front end {}, {:.1f} images per second\n\n",
      e.queries, e.queries_with_match, options.frontend, experiment.images_per_second);
  fmt::print("at threshold {:g}:  {:>10} {:>6} {:>14} {:>11}\n", e.fixed.threshold, "detections", "right",
             "precision (%)", "recall (%)");
  fmt::print("{:{}}  {:>10} {:>6} {:>14.1f} {:>11.1f}\n\n", "",
             fmt::formatted_size("at threshold {:g}:", e.fixed.threshold), e.fixed.detections, e.fixed.right,
             100 * e.fixed.precision, 100 * e.fixed.recall);
  fmt::print("average precision             {:.3f}\n", e.average_precision);
  fmt::print("recall at 100 % precision     {:.3f}\n", e.recall_at_100);
  fmt::print("recall at 95 % precision      {:.3f}\n", e.recall_at_95);
  fmt::print("best F1                       {:.3f} at threshold {:g}\n", e.best_f1, e.best_f1_threshold);
  for (std::size_t k = 0; k < recall_ranks.size(); ++k) {
    fmt::print("{:<30}{:.3f}\n", fmt::format("recall@{}", recall_ranks[k]), e.recall_at[k]);
  }
}

void eval(const Options& options) {
  const Experiment results = experiment(options);
  const Evaluation evaluation = evaluate(results.scores, results.truth, options.config.detection.threshold);
  if (!options.scores.empty()) write_npy(options.scores, results.scores);
  if (!options.plot.empty()) {
    write_evaluation_plot(options.plot, evaluation, results.scores, results.truth, results.title);
  }
  if (!options.json.empty()) {
    const ordered_json json = to_json(evaluation, results, options);
    write_file(options.json, [&](std::ostream& out) { out << json.dump(2) << '\n'; });
  }
  print(evaluation, results, options);
}

void add_ground_truth_options(CLI::App& command, Options& options) {
  constexpr const char* group = "Ground truth";
  command
      .add_option("--ground-truth", options.ground_truth,
                  "Matches (`query: candidate ...` a line, or a MATLAB .mat matrix) or poses (KITTI, TUM, "
                  "CSV with x,y "
                  "or lat,lon); of the queries, when there are two traverses")
      ->required()
      ->type_name("FILE")
      ->group(group);
  command
      .add_option("--radius", options.radius, "For poses: metres within which two images show the same place")
      ->check(CLI::PositiveNumber.description(""))
      ->group(group);
  command
      .add_option("--reference-poses", options.reference_poses,
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
  command.add_option("--side", options.side, "Which images of an oxford layout to take")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, Side>{{"left", Side::left}, {"right", Side::right}})
              .description(""))
      ->type_name("left|right")
      ->group(group);
}

}  // namespace

void add_eval(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("eval", "Measure precision and recall against ground truth");
  command->add_option("SOURCE", options->source,
                      "One sequence: folder, glob in quotes, list file (.txt) or video");
  command->add_option("--reference", options->reference, "Two traverses: where the map images are")
      ->type_name("DIR");
  command->add_option("--query", options->query, "Two traverses: where the query images are")
      ->type_name("DIR");
  add_ground_truth_options(*command, *options);
  constexpr const char* results = "Results";
  command
      ->add_option("--scores", options->scores,
                   "Similarities: float32, queries x candidates, NaN if not admissible")
      ->type_name("OUT.npy")
      ->group(results);
  command->add_option("--json", options->json, "All figures, the curve and the parameters")
      ->type_name("OUT.json")
      ->group(results);
  command->add_option("--plot", options->plot, "Precision-recall curve and similarity matrix")
      ->type_name("OUT.svg")
      ->group(results);
  const CLI::Option* exclude = command
                                   ->add_option("--exclude-recent", options->config.exclude_recent,
                                                "Do not compare an image with so many just before it")
                                   ->check(CLI::NonNegativeNumber.description(""))
                                   ->capture_default_str();
  add_frontend_option(*command, options->frontend);
  add_threshold_option(*command, options->config.detection.threshold);
  add_match_options(*command, options->config.match);
  add_temporal_option(*command, options->config.temporal)->capture_default_str();
  add_region_options(*command, options->config.regions);
  const CLI::Option* side = command->get_option("--side");
  command->callback([options, command, side, exclude] {
    settle_thresholds(*command, options->config);
    check(*options, side->count() > 0, exclude->count() > 0);
    eval(*options);
  });
}

}  // namespace sailmap::app
