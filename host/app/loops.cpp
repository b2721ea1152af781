// sailmap loops: the loop closures of a map, listed, chosen and drawn.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "commands.hpp"
#include "json_output.hpp"
#include "load_map.hpp"
#include "loop_list.hpp"
#include "loop_pictures.hpp"
#include "map/config_json.hpp"
#include "options.hpp"
#include "sailmap/error.hpp"

namespace sailmap::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct Options {
  std::string map;
  LoopChoice choice;
  std::string images;
  bool json = false;
  PictureOptions pictures;
};

// "17" or "10..20".
void parse_range(const std::string& text, LoopChoice& choice) {
  const auto dots = text.find("..");
  try {
    std::size_t end = 0;
    choice.first_image = std::stoi(text, &end);
    choice.last_image = choice.first_image;
    if (dots != std::string::npos && end == dots) {
      choice.last_image = std::stoi(text.substr(dots + 2), &end);
      end += dots + 2;
    }
    if (end == text.size() && choice.first_image >= 0 && choice.first_image <= choice.last_image) return;
  } catch (const std::logic_error&) {  // not a number, or one that is too large
  }
  throw UsageError("--image takes the number of an image, or A..B: " + text);
}

// As `run --json` says it.
ordered_json fields_of(const Update& update, const TopologicalMap& map) {
  ordered_json json = {{"image", update.image}, {"name", update.name}};
  const int best = update.detection.best.node;
  json["node_name"] = best < 0 ? ordered_json() : ordered_json(name_of_node(map, best));
  json.update(to_json(update.detection));
  return json;
}

std::string text_of(const Candidate& candidate) {
  return candidate.node < 0 ? "-" : fmt::format("{:.4g} ({})", candidate.similarity, candidate.node);
}

void print_table(const std::vector<const Update*>& loops, const TopologicalMap& map) {
  fmt::print("{:>7} {:>7} {:>11} {:>18} {:>8}  {:<15}  {}\n", "image", "node", "similarity",
             "runner-up (node)", "regions", "reason", "names");
  for (const Update* update : loops) {
    const Detection& d = update->detection;
    const bool found = d.best.node >= 0;
    fmt::print("{:>7} {:>7} {:>11} {:>18} {:>8}  {:<15}  {}\n", update->image,
               found ? std::to_string(d.best.node) : "-",
               found ? fmt::format("{:.4g}", d.best.similarity) : "-", text_of(d.runner_up), d.matches.size(),
               name(d.reason),
               found ? fmt::format("{} at {}", update->name, name_of_node(map, d.best.node)) : update->name);
  }
  fmt::print("{} listed; the map has {} images and {} loops\n", loops.size(), map.images(), map.loops());
}

void list(const Options& options) {
  const StoredMap stored = load_map(options.map);
  const std::vector<const Update*> loops = chosen_loops(stored.map, options.choice);
  std::vector<std::string> pictures(loops.size());
  int failed = 0;
  if (!options.pictures.folder.empty()) pictures = draw_loops(stored, loops, options.pictures, failed);
  if (!options.json) {
    print_table(loops, stored.map);
  } else {
    for (std::size_t i = 0; i < loops.size(); ++i) {
      ordered_json json = fields_of(*loops[i], stored.map);
      if (!options.pictures.folder.empty()) {
        json["picture"] = pictures[i].empty() ? ordered_json() : ordered_json(pictures[i]);
      }
      print_json(json);
    }
  }
  if (failed > 0) {
    throw Error(fmt::format("{}: {} of {} pairs could not be drawn", options.map, failed, loops.size()));
  }
}

void add_choice_options(CLI::App& command, Options& options) {
  constexpr const char* group = "Which";
  LoopChoice& choice = options.choice;
  command.add_option("--min-similarity", choice.least, "Of at least this similarity")->group(group);
  command.add_option("--max-similarity", choice.most, "Of at most this similarity")->group(group);
  command.add_option("--image", options.images, "Of this image, by number, or of the images A to B")
      ->type_name("A..B")
      ->group(group);
  command.add_option("--node", choice.node, "With this node")
      ->check(CLI::NonNegativeNumber.description(""))
      ->group(group);
  one_of(command.add_option("--reason", choice.reason,
                            "Detections that ended so; all but accepted are rejections, and the best node is "
                            "the one that was rejected"),
         loop_reasons())
      ->capture_default_str()
      ->group(group);
  one_of(command.add_option("--sort", choice.sort,
                            "image: in order; similarity: highest first; doubt: first those whose runner-up "
                            "is nearest to the best"),
         loop_orders())
      ->capture_default_str()
      ->group(group);
  command.add_option("--limit", choice.limit, "At most so many; 0: all")
      ->check(CLI::NonNegativeNumber.description(""))
      ->capture_default_str()
      ->group(group);
}

}  // namespace

void add_loops(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("loops", "List the loop closures of a map, and draw them");
  command->add_option("MAP", options->map, "The map")->required();
  add_json_flag(*command, options->json, "One line of JSON each, with the fields of `sailmap run --json`");
  add_choice_options(*command, *options);
  constexpr const char* group = "Pictures";
  CLI::Option* pictures =
      command
          ->add_option(
              "--pictures", options->pictures.folder,
              "Folder for a picture of each: both images, matched regions joined. Images that cannot "
              "be read are reported, and the exit code is then 1")
          ->type_name("DIR")
          ->group(group);
  command
      ->add_option("--images-in", options->pictures.images,
                   "Where relative names of images begin; without, here")
      ->type_name("DIR")
      ->needs(pictures)
      ->group(group);
  command->callback([options] {
    if (!options->images.empty()) parse_range(options->images, options->choice);
    list(*options);
  });
}

}  // namespace sailmap::app
