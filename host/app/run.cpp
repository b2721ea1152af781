// sailmap run: builds or extends a map from a stream of images, telling each loop closure as it happens.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "commands.hpp"
#include "image_pipeline.hpp"
#include "map/config_json.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "sailmap/error.hpp"
#include "sailmap/image_source.hpp"
#include "sailmap/map_store.hpp"
#include "sailmap/temporal_filter.hpp"

namespace sailmap::app {
namespace {

using nlohmann::ordered_json;

struct Options {
  std::string source;
  std::string map;
  std::string frontend;
  bool json = false;
  bool skip_bad = false;
  int max_images = 0;
  MapConfig config;
};

// Set by the first SIGINT: the run ends after the image at hand, and the map is saved.
volatile std::sig_atomic_t interrupted = 0;

void on_interrupt(int) {
  interrupted = 1;
  std::signal(SIGINT, SIG_DFL);  // a second one ends the program at once
}

// A map to go on with: the stored one, or a new one with the options of the command line. Options given that
// differ from those a stored map was made with are refused, since its similarities would no longer compare.
StoredMap open_map(const MapStore& store, const Options& options, const OptionKeys& given) {
  if (!store.exists()) return {TopologicalMap(options.config), options.frontend};
  StoredMap stored = store.load();
  ordered_json then = to_json(stored.map.config());
  ordered_json now = to_json(options.config);
  then["frontend"] = stored.frontend;
  now["frontend"] = options.frontend;
  std::string differ;
  for (const auto& [key, option] : given) {
    const ordered_json::json_pointer pointer(key);
    if (option->count() == 0 || then.at(pointer) == now.at(pointer)) continue;
    differ += fmt::format("{}{} (map {}, now {})", differ.empty() ? "" : ", ", option->get_name(),
                          then.at(pointer).dump(), now.at(pointer).dump());
  }
  if (!differ.empty()) throw Error(options.map + ": the map was made with other parameters: " + differ);
  return stored;
}

ordered_json event_of(const Update& update, const TopologicalMap& map) {
  const Detection& d = update.detection;
  ordered_json json = {{"event", "loop_closure"}, {"image", update.image}, {"name", update.name}};
  json["node_name"] = map.nodes()[static_cast<std::size_t>(d.best.node)].views.front().name;
  json.update(to_json(d));
  return json;
}

std::string line_of(const Update& update, const TopologicalMap& map) {
  const Detection& d = update.detection;
  const Node& node = map.nodes()[static_cast<std::size_t>(d.best.node)];
  // Scores of the method context lie within 0 and 1.
  const int digits = map.config().match.method == Method::context ? 3 : 1;
  std::string line = fmt::format(
      "loop closure: image {} ({}) is at node {} ({}), similarity {:.{}f}, {} regions matched", update.image,
      update.name, node.id, node.views.front().name, d.best.similarity, digits, d.matches.size());
  if (d.runner_up.node >= 0)
    line += fmt::format("; runner-up node {} with {:.{}f}", d.runner_up.node, d.runner_up.similarity, digits);
  return line;
}

std::string dump(const ordered_json& json) {
  return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

struct Counts {
  int images = 0;
  int loops = 0;
  double seconds = 0;
};

void report(const Update& update, const TopologicalMap& map, const Options& options) {
  fmt::print("{}\n", options.json ? dump(event_of(update, map)) : line_of(update, map));
  std::fflush(stdout);
}

// Unreadable images are reported and passed over when the user asked for that.
bool skip(const std::exception_ptr& fault, const Options& options, Progress& progress) {
  try {
    std::rethrow_exception(fault);
  } catch (const Error& error) {
    if (!options.skip_bad) throw;
    progress.clear();
    spdlog::warn("skipped {}", error.what());
  }
  return true;
}

void map_source(ImageSource& source, TopologicalMap& map, const std::string& frontend, const Options& options,
                Counts& counts) {
  const auto start = std::chrono::steady_clock::now();
  std::optional<int> total = source.size();
  if (options.max_images > 0) total = std::min(total.value_or(options.max_images), options.max_images);
  Progress progress("run", total);
  ImagePipeline pipeline;
  pipeline.frontend = frontend;
  pipeline.regions = map.config().regions;
  pipeline.go_on = [] { return interrupted == 0; };
  pipeline.on_fault = [&](const std::exception_ptr& fault) { return skip(fault, options, progress); };
  pipeline.use = [&](const std::string& name, Signature signature) {
    const Update& update = map.add(name, std::move(signature));
    ++counts.images;
    if (update.detection.accepted()) {
      ++counts.loops;
      progress.clear();
      report(update, map, options);
    }
    progress.step_to(counts.images);
    counts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return options.max_images == 0 || counts.images < options.max_images;
  };
  run_pipeline(source, pipeline);
}

void print_summary(const Counts& counts, const TopologicalMap& map, const Options& options) {
  const double rate = counts.seconds > 0 ? counts.images / counts.seconds : 0;
  if (options.json) {
    fmt::print("{}\n", dump({{"event", "summary"},
                             {"images", counts.images},
                             {"loops", counts.loops},
                             {"images_per_second", rate},
                             {"map", options.map},
                             {"map_images", map.images()},
                             {"nodes", map.nodes().size()},
                             {"edges", map.edges().size()},
                             {"map_loops", map.loops()}}));
    return;
  }
  fmt::print(
      "{}: {} images, {} nodes, {} edges, {} loops; this run {} images, {} loops, {:.1f} images per second\n",
      options.map, map.images(), map.nodes().size(), map.edges().size(), map.loops(), counts.images,
      counts.loops, rate);
}

void run(const Options& options, const OptionKeys& given) {
  const auto store = open_map_store(options.map);
  StoredMap stored = open_map(*store, options, given);
  const auto source = open_source(options.source);
  std::signal(SIGINT, on_interrupt);
  Counts counts;
  try {
    map_source(*source, stored.map, stored.frontend, options, counts);
  } catch (const Error& fault) {
    // Image files can be given again, so the map stays as it was; what a camera or video showed must not be
    // lost.
    if (is_image_list(options.source) || counts.images == 0) throw;
    store->save(stored.map, stored.frontend);
    throw Error(
        fmt::format("{}; the {} images before it are in {}", fault.what(), counts.images, options.map));
  }
  if (counts.images == 0) throw Error(options.source + ": no image could be read");
  store->save(stored.map, stored.frontend);
  print_summary(counts, stored.map, options);
}

}  // namespace

void add_run(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("run", "Build or extend a map from a folder, video or camera");
  command
      ->add_option(
          "SOURCE", options->source,
          "Folder of images (natural order), glob in quotes, list file (.txt), image, video, or camera index")
      ->required();
  command->add_option("--map", options->map, "The map file; extended when it exists")
      ->required()
      ->type_name("FILE");
  command->add_flag("--json", options->json, "Print loop closures and summary as lines of JSON");
  command
      ->add_option("--max-images", options->max_images,
                   "Stop after so many images; 0: at the end of the source")
      ->check(CLI::NonNegativeNumber.description(""))
      ->capture_default_str();
  command->add_flag(
      "--skip-bad", options->skip_bad,
      "Report images that cannot be read and go on; without, the run fails and the map stays as it was");
  add_frontend_option(*command, options->frontend);
  OptionKeys keys = add_map_options(*command, options->config);
  keys["/frontend"] = command->get_option("--frontend");
  command->callback([options, command, keys] {
    settle_thresholds(*command, options->config);
    const bool context = options->config.match.method == Method::context;
    if (context && keys.at("/temporal")->count() == 0) options->config.temporal = default_temporal_images;
    run(*options, keys);
  });
}

}  // namespace sailmap::app
