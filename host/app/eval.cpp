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
#include "experiment_options.hpp"
#include "json_output.hpp"
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

struct Options : Experiment {
  fs::path scores;
  fs::path json;
  fs::path plot;
  fs::path table;
  fs::path markdown;
  fs::path csv;
};

constexpr const char* standard_output = "-";

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

// What a report shows of the images.
nlohmann::ordered_json details_of(const Measurement& result, const GroundTruth& truth) {
  const DataSet& data = result.data;
  report::EvaluationNames names;
  names.queries = names_of(data.queries(), data.selection, result.images);
  if (data.traverses()) names.candidates = names_of(data.candidates(), data.selection, result.candidates);
  const int same_place = result.recogniser.config.detection.same_place_nodes;
  return report::evaluation_details(result.scores, truth, names, same_place);
}

// All figures, a line each, and the details, a line a part.
std::string text_with_details(const Measurement& result, const GroundTruth& truth) {
  std::string text = to_json(result).dump(2);
  text.erase(text.rfind("\n}"));
  const auto details = details_of(result, truth);
  for (const auto& [key, value] : details.items()) {
    text += fmt::format(",\n  \"{}\": {}", key, report::dump(value));
  }
  return text + "\n}\n";
}

void eval(const Options& options) {
  GroundTruth truth;
  const Measurement result = measure(options, truth);
  if (!options.scores.empty()) write_npy(options.scores, result.scores);
  if (!options.plot.empty()) {
    write_evaluation_plot(options.plot, result.evaluation, result.scores, truth, title_of(result));
  }
  const bool to_standard_output = options.json == standard_output;
  if (!options.json.empty() && !to_standard_output) {
    const std::string text = text_with_details(result, truth);
    write_file(options.json, [&text](std::ostream& out) { out << text; });
  }
  if (to_standard_output) {
    auto json = to_json(result);
    json.update(details_of(result, truth));
    print_json(json);
  } else {
    print(result);
  }
}

void write_text(const fs::path& path, const std::string& text) {
  if (!path.empty()) write_file(path, [&text](std::ostream& out) { out << text; });
}

void eval_table(const Options& options) {
  const TableConfig config = read_table_config(options.table, options.recogniser);
  const Table table = evaluate_table(config, options.table.string());
  if (!options.plot.empty()) write_table_plot(options.plot, table);
  if (options.json != standard_output) write_text(options.json, to_json(table).dump(2) + '\n');
  write_text(options.markdown, to_markdown(table));
  write_text(options.csv, to_csv(table));
  if (options.json == standard_output) {
    print_json(to_json(table));
  } else {
    fmt::print("{}", to_text(table));
  }
}

void add_result_options(CLI::App& command, Options& options) {
  constexpr const char* group = "Results";
  command
      .add_option("--scores", options.scores,
                  "Similarities: float32, queries x candidates, NaN if not admissible")
      ->type_name("OUT.npy")
      ->group(group);
  command
      .add_option("--json", options.json,
                  "All figures, the curves and the parameters; -: as one line on standard output, in place "
                  "of the text")
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
  add_data_options(*command, *options);
  command
      ->add_option("--table", options->table,
                   "Several data sets and methods, as this JSON file says (docs/data_sets.md)")
      ->type_name("CONFIG");
  add_result_options(*command, *options);
  add_recognition_options(*command, *options);
  add_threshold_option(*command, options->recogniser.config.detection.threshold,
                       fmt::format(", {:g} for fabmap (log-odds: p = 0.99), {:g} for bow",
                                   fabmap::default_threshold, bow::default_threshold));
  const CLI::Option* threshold = command->get_option("--threshold");
  command->callback([options, command, threshold] {
    if (!options->table.empty()) {
      check_table(*command);
      eval_table(*options);
      return;
    }
    settle_experiment(*command, *options, threshold->count() > 0);
    if (!options->markdown.empty() || !options->csv.empty()) {
      throw UsageError("--markdown and --csv go with --table");
    }
    eval(*options);
  });
}

}  // namespace sailmap::app
