#include "options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <memory>

#include "commands.hpp"
#include "map/config_json.hpp"
#include "sailmap/frontend.hpp"
#include "sailmap/xrt.hpp"

namespace sailmap::app {
namespace {

constexpr const char* regions_group = "Regions (spec 8)";
constexpr const char* match_group = "Matching (spec 10)";
constexpr const char* detection_group = "Detection (spec 11)";
constexpr const char* map_group = "Map (spec 11)";
constexpr const char* xrt_group = "FPGA (front end xrt)";

template <class Enum>
std::map<std::string, Enum> by_name(std::initializer_list<Enum> values) {
  std::map<std::string, Enum> out;
  for (const Enum value : values) out.emplace(name(value), value);
  return out;
}

// An option that takes one of the names of an enumeration and shows its default by name.
template <class Enum>
CLI::Option* add_choice(CLI::App& command, const std::string& flag, Enum& value, const std::string& help,
                        std::initializer_list<Enum> values) {
  const auto names = by_name(values);
  std::string list;
  for (const auto& [text, unused] : names) list += (list.empty() ? "" : "|") + text;
  return command.add_option(flag, value, help)
      ->transform(CLI::CheckedTransformer(names).description(""))
      ->default_str(std::string(name(value)))
      ->type_name(list);
}

// They hold an image against others by words, which signatures and map files do not have.
std::string refuse_words(const std::string& method) {
  const bool on_words = method == fabmap_name || method == bow_name;
  return on_words ? method + " is a method of `sailmap eval` alone" : "";
}

void merge(OptionKeys& into, OptionKeys other) { into.merge(std::move(other)); }

// What --frontend xrt needs besides; checked, and handed over, when all is parsed.
void add_xrt_options(CLI::App& command, const std::string& frontend) {
  struct Options {
    XrtSettings settings;
    int timeout = static_cast<int>(XrtSettings{}.timeout.count());
  };
  const auto options = std::make_shared<Options>();
  command
      .add_option("--xclbin", options->settings.xclbin,
                  "What the card is to be: file with the kernel, for maps, signatures or both")
      ->type_name("FILE")
      ->group(xrt_group);
  command.add_option("--device", options->settings.device, "Which card, by XRT's number")
      ->capture_default_str()
      ->group(xrt_group);
  command
      .add_option("--device-timeout", options->timeout,
                  "A card that takes longer for an image hangs, milliseconds")
      ->check(CLI::Range(1, 3600000).description(""))
      ->capture_default_str()
      ->group(xrt_group);
  one_of(command.add_option("--fallback", options->settings.fallback,
                            "Front end that takes over when the card fails; without it that is an error"),
         {"fixed"})
      ->group(xrt_group);
  command.parse_complete_callback([&frontend, options] {
    if (options->settings.xclbin.empty()) {
      if (frontend == "xrt") throw UsageError("--frontend xrt needs --xclbin FILE");
      return;
    }
    options->settings.timeout = std::chrono::milliseconds(options->timeout);
    options->settings.warn = [](const std::string& what) { spdlog::warn("{}", what); };
    set_xrt(options->settings);
  });
}

}  // namespace

CLI::Option* one_of(CLI::Option* option, const std::vector<std::string>& names) {
  return option->check(CLI::IsMember(names).description(""))
      ->type_name(fmt::format("{}", fmt::join(names, "|")));
}

std::vector<std::string> to_strings(const std::vector<std::string_view>& names) {
  return {names.begin(), names.end()};
}

void add_frontend_option(CLI::App& command, std::string& frontend) {
  frontend = frontend_names().front();
  one_of(command.add_option("--frontend", frontend, "What computes the maps"), frontend_names())
      ->capture_default_str();
  add_xrt_options(command, frontend);
}

OptionKeys add_region_options(CLI::App& command, RegionConfig& config) {
  OptionKeys keys;
  keys["/regions/max_regions"] =
      command.add_option("--max-regions", config.max_regions, "At most so many regions an image")
          ->check(CLI::Range(1, 1000).description(""));
  keys["/regions/stop_ratio"] = command
                                    .add_option("--stop-ratio", config.stop_ratio,
                                                "Stop at this part of the strongest saliency (paper: 1/4)")
                                    ->check(CLI::Range(0.0, 1.0).description(""));
  keys["/regions/box_side"] =
      command.add_option("--box-side", config.box_side, "Side of a region, base-level pixels")
          ->check(CLI::Range(2, 1000).description(""));
  keys["/regions/inhibition"] =
      add_choice(command, "--inhibition", config.inhibition, "Shape of inhibition of return",
                 {Inhibition::box, Inhibition::disk, Inhibition::gaussian});
  keys["/regions/inhibition_radius"] =
      command
          .add_option("--inhibition-radius", config.inhibition_radius,
                      "Radius of the disk, sigma of the Gaussian, base-level pixels")
          ->check(CLI::PositiveNumber.description(""));
  keys["/regions/descriptor"] =
      add_choice(command, "--descriptor", config.descriptor, "Descriptor: eq. 3-4 or eq. 5 of the paper",
                 {DescriptorKind::conspicuity, DescriptorKind::background});
  keys["/regions/signature"] = add_choice(
      command, "--signature", config.signature,
      "Who makes the signature: host, in floating point, or chip, as the signature kernel does, or that "
      "kernel itself on a card that has it",
      {SignatureMaker::host, SignatureMaker::chip});
  for (const auto& [key, option] : keys) option->group(regions_group);
  for (const char* key :
       {"/regions/max_regions", "/regions/stop_ratio", "/regions/box_side", "/regions/inhibition_radius"}) {
    keys[key]->capture_default_str();
  }
  return keys;
}

OptionKeys add_constraint_options(CLI::App& command, MatchConfig& config) {
  OptionKeys keys;
  keys["/match/search_radius"] =
      command
          .add_option("--search-radius", config.search_radius,
                      "Constraint 1: matched regions are nearer than this part of the diagonal")
          ->check(CLI::PositiveNumber.description(""))
          ->capture_default_str();
  keys["/match/displacement_tolerance"] =
      command
          .add_option("--displacement-tolerance", config.displacement_tolerance,
                      "Constraint 2: displacements agree within this part of the diagonal")
          ->check(CLI::NonNegativeNumber.description(""))
          ->capture_default_str();
  for (const auto& [key, option] : keys) option->group(match_group);
  return keys;
}

OptionKeys add_match_options(CLI::App& command, MatchConfig& config) {
  OptionKeys keys = add_constraint_options(command, config);
  // A check that comes later is asked first.
  keys["/match/method"] = add_choice(command, "--method", config.method, "Similarity",
                                     {Method::paper, Method::paper_weighted, Method::context})
                              ->transform(CLI::Validator(refuse_words, ""))
                              ->group(match_group);
  return keys;
}

std::vector<CLI::Option*> add_recogniser_options(CLI::App& command, Recogniser& recogniser) {
  recogniser.method = name(MatchConfig{}.method);
  CLI::Option* method =
      one_of(command.add_option("--method", recogniser.method,
                                "Similarity; fabmap and bow: by visual words, need --vocabulary"),
             recogniser_names())
          ->capture_default_str();
  CLI::Option* vocabulary =
      command
          .add_option("--vocabulary", recogniser.vocabulary,
                      "Of the methods fabmap and bow: what `sailmap fabmap train` wrote")
          ->type_name("FILE");
  method->group(match_group);
  vocabulary->group(match_group);
  return {method, vocabulary};
}

CLI::Option* add_threshold_option(CLI::App& command, double& threshold, const std::string& more) {
  std::string defaults;
  for (const std::string_view method : method_names()) {
    defaults += fmt::format("{}{:g} for {}", defaults.empty() ? "" : ", ",
                            default_threshold(method_from_name(method)), method);
  }
  defaults += more;
  return command
      .add_option("--threshold", threshold,
                  "Similarity above which it is the same place (Th_LCD); default " + defaults)
      ->group(detection_group);
}

void settle_thresholds(const CLI::App& command, MapConfig& config) {
  const double threshold = default_threshold(config.match.method);
  if (command.get_option("--threshold")->count() == 0) config.detection.threshold = threshold;
  const CLI::Option* sparse = command.get_option_no_throw("--sparse-threshold");
  if (sparse == nullptr || sparse->count() == 0) config.sparse_threshold = threshold;
  config.regions.describe_place = config.match.method == Method::context;
}

OptionKeys add_detection_options(CLI::App& command, DetectionConfig& config) {
  OptionKeys keys;
  keys["/detection/threshold"] = add_threshold_option(command, config.threshold);
  keys["/detection/min_matches"] =
      command.add_option("--min-matches", config.min_matches, "Fewest matched regions for a loop closure")
          ->check(CLI::NonNegativeNumber.description(""));
  keys["/detection/ambiguity_ratio"] =
      command
          .add_option("--ambiguity-ratio", config.ambiguity_ratio,
                      "Refuse when another place reaches this part of the best similarity; above 1: never")
          ->check(CLI::PositiveNumber.description(""));
  keys["/detection/same_place_nodes"] =
      command
          .add_option("--same-place-nodes", config.same_place_nodes,
                      "Nodes so near in number to the best are no other place")
          ->check(CLI::NonNegativeNumber.description(""));
  for (const auto& [key, option] : keys) {
    option->group(detection_group);
    if (key != "/detection/threshold") option->capture_default_str();
  }
  return keys;
}

CLI::Option* add_temporal_option(CLI::App& command, int& images) {
  return command
      .add_option("--temporal", images,
                  "Let the images just before speak too: how many; 0: each image for itself")
      ->check(CLI::Range(0, 1000).description(""))
      ->group(detection_group);
}

OptionKeys add_map_options(CLI::App& command, MapConfig& config) {
  OptionKeys keys;
  keys["/exclude_recent"] = command
                                .add_option("--exclude-recent", config.exclude_recent,
                                            "Do not compare with nodes made by so many newest images")
                                ->check(CLI::NonNegativeNumber.description(""))
                                ->capture_default_str();
  keys["/loop_edges"] =
      command.add_flag("!--no-loop-edges", config.loop_edges, "Strict paper mode: a loop makes no edge");
  keys["/sparse"] =
      command.add_flag("--sparse", config.sparse, "One node for a group of images of one place");
  keys["/sparse_threshold"] =
      command.add_option("--sparse-threshold", config.sparse_threshold,
                         "Similarity above which an image joins the active node of a sparse map; default as "
                         "--threshold");
  keys["/detection/ranked_nodes"] =
      command
          .add_option(
              "--rank-up-to", config.detection.ranked_nodes,
              "While the map has at most so many nodes, every image has a most similar one; of larger "
              "maps paper and paper_weighted say only what closes a loop, which is quicker")
          ->check(CLI::NonNegativeNumber.description(""))
          ->capture_default_str();
  keys["/temporal"] =
      add_temporal_option(command, config.temporal)
          ->default_str(fmt::format("{} with the method context, else 0", default_temporal_images));
  for (const auto& [key, option] : keys) option->group(map_group);
  merge(keys, add_region_options(command, config.regions));
  merge(keys, add_match_options(command, config.match));
  merge(keys, add_detection_options(command, config.detection));
  return keys;
}

}  // namespace sailmap::app
