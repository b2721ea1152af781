// sailmap eval: precision and recall on a sequence, or on two traverses, with ground truth (spec 12); or a
// table of several data sets and methods.
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "commands.hpp"
#include "measurement.hpp"
#include "options.hpp"
#include "report/evaluation_file.hpp"
#include "report/page.hpp"
#include "sailmap/bag_of_words.hpp"
#include "sailmap/figures.hpp"
#include "sailmap/file.hpp"
#include "sailmap/image_source.hpp"
#include "sailmap/npy.hpp"
#include "table_report.hpp"

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
  fs::path table;
  fs::path markdown;
  fs::path csv;
};

// What is said of each data set and method in the table's configuration.
constexpr std::array<const char*, 14> of_one_experiment = {
    "SOURCE",     "--reference", "--query",          "--ground-truth", "--radius",    "--reference-poses",
    "--layout",   "--side",      "--exclude-recent", "--method",       "--threshold", "--vocabulary",
    "--temporal", "--scores"};

void check_table(const CLI::App& command) {
  for (const char* name : of_one_experiment) {
    if (command.get_option(name)->count() > 0) {
      throw UsageError(fmt::format("{} does not go with --table: it belongs in the configuration", name));
    }
  }
}

void check(const Options& options, bool side_given, bool exclude_given) {
  const DataSet& data = options.data;
  if (!options.markdown.empty() || !options.csv.empty()) {
    throw UsageError("--markdown and --csv go with --table");
  }
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
  if (options.recogniser.on_words() == options.recogniser.vocabulary.empty()) {
    throw UsageError("--vocabulary and the methods fabmap and bow go together");
  }
  if (data.ground_truth.empty()) throw UsageError("eval needs --ground-truth");
}

Measurement measure_words(const DataSet& data, const Recogniser& recogniser, GroundTruth& truth) {
  const fabmap::Vocabulary vocabulary = fabmap::read_vocabulary(recogniser.vocabulary);
  truth = read_truth(data);
  return measure(data, truth, describe(data, vocabulary), recogniser, vocabulary);
}

// The ground truth first: a wrong one should not cost the user the wait for the images.
Measurement measure_signatures(const DataSet& data, const Recogniser& recogniser, GroundTruth& truth) {
  truth = read_truth(data);
  return measure(data, truth, describe(data, recogniser.frontend, recogniser.config.regions), recogniser);
}

// As the images are called; the frames of a video by their numbers.
std::vector<std::string> names_of(const std::string& source, const Selection& selection, int count) {
  std::vector<std::string> names;
  if (is_image_list(source)) {
    for (const fs::path& path : selected_images(source, selection)) names.push_back(path.string());
  } else {
    for (int i = 0; i < count; ++i) names.push_back(fmt::format("{}#{}", source, i));
  }
  return names;
}

// All figures, a line each, and what a report shows of the images, a line a part.
std::string text_with_details(const Measurement& result, const GroundTruth& truth) {
  const DataSet& data = result.data;
  report::EvaluationNames names;
  names.queries = names_of(data.queries(), data.selection, result.images);
  if (data.traverses()) names.candidates = names_of(data.candidates(), data.selection, result.candidates);
  const int same_place = result.recogniser.config.detection.same_place_nodes;
  const auto details = report::evaluation_details(result.scores, truth, names, same_place);
  std::string text = to_json(result).dump(2);
  text.erase(text.rfind("\n}"));
  for (const auto& [key, value] : details.items()) {
    text += fmt::format(",\n  \"{}\": {}", key, report::dump(value));
  }
  return text + "\n}\n";
}

void eval(const Options& options) {
  GroundTruth truth;
  const Measurement result = options.recogniser.on_words()
                                 ? measure_words(options.data, options.recogniser, truth)
                                 : measure_signatures(options.data, options.recogniser, truth);
  if (!options.scores.empty()) write_npy(options.scores, result.scores);
  if (!options.plot.empty()) {
    write_evaluation_plot(options.plot, result.evaluation, result.scores, truth, title_of(result));
  }
  if (!options.json.empty()) {
    const std::string text = text_with_details(result, truth);
    write_file(options.json, [&text](std::ostream& out) { out << text; });
  }
  print(result);
}

void write_text(const fs::path& path, const std::string& text) {
  if (!path.empty()) write_file(path, [&text](std::ostream& out) { out << text; });
}

void eval_table(const Options& options) {
  const TableConfig config = read_table_config(options.table, options.recogniser);
  const Table table = evaluate_table(config, options.table.string());
  if (!options.plot.empty()) write_table_plot(options.plot, table);
  if (!options.json.empty()) write_text(options.json, to_json(table).dump(2) + '\n');
  write_text(options.markdown, to_markdown(table));
  write_text(options.csv, to_csv(table));
  fmt::print("{}", to_text(table));
}

void add_ground_truth_options(CLI::App& command, Options& options) {
  constexpr const char* group = "Ground truth";
  DataSet& data = options.data;
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
  command.add_option("--json", options.json, "All figures, the curves and the parameters")
      ->type_name("OUT.json")
      ->group(group);
  command
      .add_option("--plot", options.plot,
                  "Precision-recall curve and similarity matrix; of a table bars of precision and recall")
      ->type_name("OUT.svg")
      ->group(group);
  command.add_option("--markdown", options.markdown, "The table in Markdown")
      ->type_name("OUT.md")
      ->group(group);
  command.add_option("--csv", options.csv, "The table, a line each data set and method")
      ->type_name("OUT.csv")
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
  command
      ->add_option("--table", options->table,
                   "Several data sets and methods, as this JSON file says (docs/data_sets.md)")
      ->type_name("CONFIG");
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
                       fmt::format(", {:g} for fabmap (log-odds: p = 0.99), {:g} for bow",
                                   fabmap::default_threshold, bow::default_threshold));
  add_recogniser_options(*command, recogniser);
  add_constraint_options(*command, config.match);
  add_temporal_option(*command, config.temporal)->capture_default_str();
  add_region_options(*command, config.regions);
  const CLI::Option* side = command->get_option("--side");
  const CLI::Option* threshold = command->get_option("--threshold");
  command->callback([options, command, side, exclude, threshold] {
    if (!options->table.empty()) {
      check_table(*command);
      eval_table(*options);
      return;
    }
    options->data.selection.oxford = options->layout == "oxford";
    settle(options->recogniser, threshold->count() > 0);
    check(*options, side->count() > 0, exclude->count() > 0);
    eval(*options);
  });
}

}  // namespace sailmap::app
