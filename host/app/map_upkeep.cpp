// sailmap map check, recover, merge and prune: map files over the years.
#include <fmt/format.h>

#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "commands.hpp"
#include "json_output.hpp"
#include "sailmap/error.hpp"
#include "sailmap/map_maintenance.hpp"

namespace sailmap::app {
namespace {

struct Options {
  std::string file;
  std::string other;
  std::string out;
  bool json = false;
  PruneOptions prune{std::numeric_limits<double>::infinity(), 0};
};

void check(const Options& options) {
  const MapCheck result = check_map(options.file);
  if (options.json) {
    print_json({{"map", options.file},
                {"sound", result.faults.empty()},
                {"images", result.images},
                {"nodes", result.nodes},
                {"faults", result.faults}});
  } else if (result.faults.empty()) {
    fmt::print("{}: sound, {} images, {} nodes\n", options.file, result.images, result.nodes);
  } else {
    for (const std::string& fault : result.faults) fmt::print("{}\n", fault);
  }
  if (!result.faults.empty()) {
    throw Error(fmt::format("{}: damaged, {} faults; 'sailmap map recover' saves what can be read",
                            options.file, result.faults.size()));
  }
}

void recover(const Options& options) {
  const MapRecovery result = recover_map(options.file, options.out);
  if (options.json) {
    print_json({{"map", options.out},
                {"images", result.images},
                {"nodes", result.nodes},
                {"lost_rows", result.lost_rows}});
  } else {
    fmt::print("{}: {} images and {} nodes recovered, {} rows lost\n", options.out, result.images,
               result.nodes, result.lost_rows);
  }
}

void merge(const Options& options) {
  const MapMerge result = merge_maps(options.file, options.other, options.out);
  if (options.json) {
    print_json({{"map", options.out},
                {"images_added", result.images},
                {"left_out", result.left_out},
                {"loops_across", result.loops_across}});
  } else {
    fmt::print("{}: {} images added to those of {}, {} of them at its nodes; {} without signature left out\n",
               options.out, result.images, options.file, result.loops_across, result.left_out);
  }
}

void prune(const Options& options) {
  const std::string& out = options.out.empty() ? options.file : options.out;
  const MapPruning result = prune_map(options.file, out, options.prune);
  if (options.json) {
    print_json(
        {{"map", out}, {"nodes", result.nodes}, {"joined", result.joined}, {"dropped", result.dropped}});
  } else {
    fmt::print("{}: {} nodes; {} joined with the one before, {} dropped\n", out, result.nodes, result.joined,
               result.dropped);
  }
}

CLI::App* add(CLI::App& map, const char* name, const char* description,
              const std::shared_ptr<Options>& options, void (*work)(const Options&)) {
  CLI::App* command = map.add_subcommand(name, description);
  command->add_option("FILE", options->file, "The map")->required();
  add_json_flag(*command, options->json);
  command->callback([options, work] { work(*options); });
  return command;
}

}  // namespace

void add_map_upkeep(CLI::App& map) {
  const auto options = std::make_shared<Options>();
  add(map, "check", "Read all of a map: structure, checksums, whether the parts fit together", options,
      check);
  add(map, "recover", "Make a new map of all that can be read in a damaged one", options, recover)
      ->add_option("--out", options->out, "The new map; must not exist")
      ->required()
      ->type_name("NEW");
  CLI::App* merging =
      add(map, "merge", "Join two maps: the images of OTHER, run on a copy of FILE", options, merge);
  merging->add_option("OTHER", options->other, "The map that is added")->required();
  merging->add_option("--out", options->out, "The new map; must not exist")->required()->type_name("NEW");
  CLI::App* pruning = add(map, "prune", "Make a map smaller", options, prune);
  pruning->add_option("--out", options->out, "The new map, which must not exist; without, FILE itself")
      ->type_name("NEW");
  CLI::Option* similar =
      pruning->add_option("--similar", options->prune.similar,
                          "Join a node with the one before it on the way when they are at least so similar");
  CLI::Option* unvisited = pruning
                               ->add_option("--unvisited", options->prune.unvisited,
                                            "Drop nodes that no image of the last so many sessions came to")
                               ->check(CLI::PositiveNumber.description(""));
  pruning->callback([options, similar, unvisited] {
    if (similar->count() + unvisited->count() == 0) throw UsageError("say --similar or --unvisited");
    prune(*options);
  });
}

}  // namespace sailmap::app
