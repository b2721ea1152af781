// sailmap run: builds or extends a map from a stream of images, telling each loop closure as it happens; or
// says where on a map the images are, and leaves the map as it is.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <unordered_set>
#include <utility>

#include "commands.hpp"
#include "json_output.hpp"
#include "live_view.hpp"
#include "map/config_json.hpp"
#include "options.hpp"
#include "run_report.hpp"
#include "run_source.hpp"
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
  bool localise = false;
  bool resume = false;
  int max_images = 0;
  int thumbnails = 0;
  ViewOptions view;
  MapConfig config;
};

// Options given that differ from those a stored map was made with are refused, since its similarities would
// no longer compare.
void demand_same_parameters(const StoredMap& stored, const Options& options, const OptionKeys& given) {
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
}

// A map to go on with: the one in the file, or a new one with the options of the command line.
StoredMap open_map(const MapWriter& writer, const Options& options, const OptionKeys& given) {
  std::optional<StoredMap> stored = writer.load();
  if (!stored) return {TopologicalMap(options.config), options.frontend};
  demand_same_parameters(*stored, options, given);
  return std::move(*stored);
}

SourceRun source_run(const Options& options, const StoredMap& stored) {
  SourceRun run;
  run.frontend = stored.frontend;
  run.regions = stored.map.config().regions;
  run.max_images = options.max_images;
  run.skip_bad = options.skip_bad;
  return run;
}

// The images of the last session, by name.
std::unordered_set<std::string> names_of_session(const TopologicalMap& map) {
  std::unordered_set<std::string> names;
  for (std::size_t i = static_cast<std::size_t>(map.sessions().back()); i < map.history().size(); ++i) {
    names.insert(map.history()[i].name);
  }
  return names;
}

// Commits what was appended now and then, so that a fast source does not wait for the disk at each image, and
// always before something is told about an image.
class Committer {
 public:
  explicit Committer(MapWriter& writer) : writer_(writer) {}
  void commit() {
    writer_.commit();
    last_ = Clock::now();
  }
  void commit_sometimes() {
    if (Clock::now() - last_ > std::chrono::milliseconds(100)) commit();
  }

 private:
  using Clock = std::chrono::steady_clock;
  MapWriter& writer_;
  Clock::time_point last_ = Clock::now();
};

void extend(const Options& options, const OptionKeys& given) {
  const auto source = open_source(options.source);
  LiveView view(options.view, options.map);
  MapWriter writer(options.map);
  StoredMap stored = open_map(writer, options, given);
  TopologicalMap& map = stored.map;
  SourceRun run = source_run(options, stored);
  run.thumbnail_width = options.thumbnails;
  std::unordered_set<std::string> known;
  if (options.resume) {
    known = names_of_session(map);
    run.wanted = [&](const std::string& name) { return !known.contains(name); };
    writer.resume_session(stored);
  } else {
    map.begin_session();
    writer.begin_session(stored, options.source);
  }
  const int before = map.images();
  view.begin(map, stored.frontend);
  RunCounts counts;
  Committer committer(writer);
  run.use = [&](const PipelineImage& image, Progress& progress) {
    const Update& update = map.add(image.name, image.signature);
    writer.append(map, image.signature, image.note);
    view.update(map);
    writer.note_session(counts.skipped, counts.seconds);
    if (!update.detection.accepted()) return committer.commit_sometimes();
    ++counts.loops;
    committer.commit();
    progress.clear();
    print_place(map, update.image, update.name, update.detection, "loop_closure", "loop closure",
                options.json);
  };
  try {
    run_source(*source, run, counts);
  } catch (const Error& fault) {
    writer.finish();
    const int kept = writer.committed() - before;
    if (kept == 0) throw;
    throw Error(fmt::format("{}; the {} images before it are in {}", fault.what(), kept, options.map));
  }
  if (counts.images == 0 && known.empty()) throw Error(options.source + ": no image could be read");
  writer.note_session(counts.skipped, counts.seconds);
  writer.finish();
  print_run_summary(counts, map, options.map, options.json);
}

void localise(const Options& options, const OptionKeys& given) {
  const MapStore store(options.map);
  if (!store.exists()) throw Error(options.map + ": no such file");
  StoredMap stored = store.load();
  demand_same_parameters(stored, options, given);
  const auto source = open_source(options.source);
  SourceRun run = source_run(options, stored);
  RunCounts counts;
  run.use = [&](const PipelineImage& image, Progress& progress) {
    const Detection detection = stored.map.locate(image.name, image.signature);
    if (detection.accepted()) ++counts.loops;
    if (!detection.accepted() && !options.json) return;
    progress.clear();
    print_place(stored.map, counts.images, image.name, detection, detection.accepted() ? "located" : "lost",
                "located", options.json);
  };
  run_source(*source, run, counts);
  if (counts.images == 0) throw Error(options.source + ": no image could be read");
  if (options.json) {
    print_json({{"event", "summary"},
                {"images", counts.images},
                {"located", counts.loops},
                {"skipped", counts.skipped},
                {"map", options.map}});
  } else {
    fmt::print("{}: {} of {} images located\n", options.map, counts.loops, counts.images);
  }
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
  command
      ->add_option(
          "--map", options->map,
          "The map file. One that exists is extended by a new session: the robot may have been moved, "
          "so no edge leads to its first image")
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
      "Report images that cannot be read and go on; without, the run fails, and the images before are kept");
  CLI::Option* localise_flag = command->add_flag(
      "--localise", options->localise, "Only say where on the map the images are; the map is not changed");
  CLI::Option* resume = command->add_flag("--resume", options->resume,
                                          "Go on with the map's last session, after a run that was "
                                          "interrupted: images that it has by name are left out");
  CLI::Option* thumbnails =
      command
          ->add_option("--thumbnails", options->thumbnails,
                       "Keep a picture of each image in the map, so many pixels wide; 0: none")
          ->check(CLI::Range(0, 4096).description(""))
          ->capture_default_str();
  localise_flag->excludes(resume)->excludes(thumbnails);
  add_view_options(*command, options->view);
  localise_flag->excludes(command->get_option("--view"));
  add_frontend_option(*command, options->frontend);
  OptionKeys keys = add_map_options(*command, options->config);
  keys["/frontend"] = command->get_option("--frontend");
  command->callback([options, command, keys] {
    settle_thresholds(*command, options->config);
    const bool context = options->config.match.method == Method::context;
    if (context && keys.at("/temporal")->count() == 0) options->config.temporal = default_temporal_images;
    options->localise ? localise(*options, keys) : extend(*options, keys);
  });
}

}  // namespace sailmap::app
