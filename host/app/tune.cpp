// sailmap tune: the threshold that gives a wanted precision, from a precision-recall curve.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "evaluation_file.hpp"
#include "experiment_options.hpp"
#include "json_output.hpp"
#include "load_map.hpp"
#include "map/config_json.hpp"
#include "sailmap/error.hpp"
#include "sailmap/map_maintenance.hpp"
#include "threshold_choice.hpp"

namespace sailmap::app {
namespace {

using nlohmann::ordered_json;

struct Options : Experiment {
  std::string evaluation;
  double precision = 0.95;
  std::string map;
  bool json = false;
};

// What a similarity depends on, by the keys of the configuration.
std::vector<std::string> keys_of_similarity(const ordered_json& map, bool traverses) {
  std::vector<std::string> keys = {"/frontend", "/temporal"};
  for (const char* part : {"regions", "match"}) {
    for (const auto& [key, unused] : map.at(part).items())
      keys.push_back("/" + std::string(part) + "/" + key);
  }
  if (!traverses) keys.emplace_back("/exclude_recent");  // two traverses are compared whole
  return keys;
}

std::string value_at(const ordered_json& json, const std::string& key) {
  const ordered_json::json_pointer pointer(key);
  return json.contains(pointer) ? json.at(pointer).dump() : "none";
}

// Similarities of other parameters do not compare with the map's.
void demand_same(const std::string& map, const ordered_json& of_map, const ordered_json& measured,
                 const std::vector<std::string>& keys) {
  std::string differ;
  for (const std::string& key : keys) {
    const std::string then = value_at(of_map, key);
    const std::string now = value_at(measured, key);
    if (then == now) continue;
    differ += fmt::format("{}{} (map {}, measured {})", differ.empty() ? "" : ", ", key.substr(1), then, now);
  }
  if (!differ.empty()) throw Error(map + ": the map was made with other parameters: " + differ);
}

ordered_json config_of(const StoredMap& stored) {
  ordered_json json = to_json(stored.map.config());
  json["frontend"] = stored.frontend;
  return json;
}

// The map's parameters stand for options that were not given; the others must be the map's.
void take_parameters(const StoredMap& stored, Options& options, const OptionKeys& given) {
  Recogniser& recogniser = options.recogniser;
  if (given.at("/match/method")->count() > 0 && recogniser.on_words()) {
    throw UsageError("--map does not go with the methods fabmap and bow");
  }
  ordered_json measured = to_json(recogniser.config);
  measured["frontend"] = recogniser.frontend;
  measured["exclude_recent"] = options.data.exclude_recent;
  if (!recogniser.on_words()) measured["match"]["method"] = recogniser.method;
  std::vector<std::string> keys;
  for (const auto& [key, option] : given) {
    if (option->count() > 0) keys.push_back(key);
  }
  demand_same(options.map, config_of(stored), measured, keys);
  recogniser.config = stored.map.config();
  recogniser.method = name(stored.map.config().match.method);
  recogniser.frontend = stored.frontend;
  options.data.exclude_recent = stored.map.config().exclude_recent;
}

EvaluationFile evaluate_source(const Options& options) {
  GroundTruth truth;
  return evaluation_file_from_json(to_json(measure(options, truth)));
}

ordered_json to_json(const ThresholdChoice& choice, const EvaluationFile& file, const Options& options) {
  return {{"threshold", choice.threshold},
          {"precision", choice.precision},
          {"recall", choice.recall},
          {"wanted_precision", options.precision},
          {"detections", choice.detections},
          {"right", choice.right},
          {"queries", file.evaluation.queries},
          {"queries_with_match", file.evaluation.queries_with_match},
          {"precision_at_least", choice.precision_at_least},
          {"needed_detections", choice.needed},
          {"enough", choice.detections >= choice.needed},
          {"frontend", file.config.at("frontend")},
          {"method", file.method},
          {"map", options.map.empty() ? ordered_json() : ordered_json(options.map)}};
}

void print(const ThresholdChoice& c, const EvaluationFile& file, const Options& options) {
  fmt::print("threshold   {} ({})\n", c.threshold, file.method);
  fmt::print("precision   {:.4f}: {} of {} detections are right\n", c.precision, c.right, c.detections);
  fmt::print("recall      {:.4f}: of {} queries with a true match, among {}\n", c.recall,
             file.evaluation.queries_with_match, file.evaluation.queries);
  fmt::print(
      "confidence  the precision is at least {:.4f} with 95 % confidence, were the queries independent\n",
      c.precision_at_least);
  if (!options.map.empty()) {
    fmt::print("map         {}: new images will be judged by this threshold; what it holds stays\n",
               options.map);
  }
}

void tune(const Options& options, const std::optional<StoredMap>& stored) {
  const EvaluationFile file =
      options.evaluation.empty() ? evaluate_source(options) : read_evaluation(options.evaluation);
  if (stored && !options.evaluation.empty()) {
    const ordered_json config = config_of(*stored);
    demand_same(options.map, config, file.config, keys_of_similarity(config, file.traverses));
  }
  const ThresholdChoice choice =
      choose_threshold(file.evaluation.curve, file.evaluation.queries_with_match, options.precision);
  if (choice.detections < choice.needed) {
    spdlog::warn("the threshold rests on {} detections; to claim a precision of {:g} it takes {}, all right",
                 choice.detections, options.precision, choice.needed);
  }
  // What the map holds was decided by the old threshold, and stays.
  if (stored) set_threshold(options.map, choice.threshold);
  if (options.json) {
    print_json(to_json(choice, file, options));
  } else {
    print(choice, file, options);
  }
}

// --evaluation stands for everything that says how to measure.
void check_evaluation(const CLI::App& command, const OptionKeys& keys) {
  std::vector<const CLI::Option*> measuring;
  for (const char* name : {"SOURCE", "--reference", "--query", "--ground-truth", "--radius",
                           "--reference-poses", "--layout", "--side", "--vocabulary"}) {
    measuring.push_back(command.get_option(name));
  }
  for (const auto& [key, option] : keys) measuring.push_back(option);
  for (const CLI::Option* option : measuring) {
    if (option->count() > 0) throw UsageError(option->get_name() + " does not go with --evaluation");
  }
}

}  // namespace

void add_tune(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("tune", "Find the threshold that gives a wanted precision, and write it into a map");
  add_data_options(*command, *options);
  command
      ->add_option("--evaluation", options->evaluation,
                   "What `sailmap eval --json` wrote of one data set, in place of SOURCE and ground truth")
      ->type_name("FILE");
  command
      ->add_option("--precision", options->precision,
                   "The wanted part of detections that are right, above 0 to 1. Measured on the same queries "
                   "the threshold is chosen by: keep others to test it")
      ->check(CLI::Range(1e-9, 1.0).description(""))
      ->capture_default_str();
  command
      ->add_option("--map", options->map,
                   "A map to measure as (its front end, method and parameters) and to write the threshold "
                   "into; refused when what was measured differs")
      ->type_name("FILE");
  add_json_flag(*command, options->json);
  const OptionKeys keys = add_recognition_options(*command, *options);
  command->callback([options, command, keys] {
    std::optional<StoredMap> stored;
    if (!options->evaluation.empty()) check_evaluation(*command, keys);
    if (!options->map.empty()) stored = load_map(options->map);
    if (stored && options->evaluation.empty()) take_parameters(*stored, *options, keys);
    if (options->evaluation.empty()) settle_experiment(*command, *options, false);
    tune(*options, stored);
  });
}

}  // namespace sailmap::app
