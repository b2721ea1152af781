// sailmap map: look into map files and carry them elsewhere.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "commands.hpp"
#include "map/config_json.hpp"
#include "run_report.hpp"
#include "sailmap/error.hpp"
#include "sailmap/figures.hpp"
#include "sailmap/file.hpp"
#include "sailmap/map_export.hpp"
#include "sailmap/map_store.hpp"

namespace sailmap::app {
namespace {

StoredMap load(const std::string& path) {
  const auto store = open_map_store(path);
  if (!store->exists()) throw Error(path + ": no such file");
  return store->load();
}

struct Counts {
  int paths = 0;
  int loops = 0;
};

Counts count_edges(const TopologicalMap& map) {
  Counts counts;
  for (const Edge& edge : map.edges()) ++(edge.kind == EdgeKind::path ? counts.paths : counts.loops);
  return counts;
}

void info(const std::string& path, bool json) {
  const StoredMap stored = load(path);
  const std::vector<Session> sessions = MapStore(path).sessions();
  const Counts edges = count_edges(stored.map);
  const auto config = to_json(stored.map.config());
  if (json) {
    nlohmann::ordered_json runs = nlohmann::ordered_json::array();
    for (const Session& s : sessions) {
      runs.push_back({{"source", s.source},
                      {"started", s.started},
                      {"first_image", s.first_image},
                      {"images", s.images},
                      {"skipped", s.skipped},
                      {"seconds", s.seconds}});
    }
    fmt::print("{}\n", dump({{"map", path},
                             {"frontend", stored.frontend},
                             {"images", stored.map.images()},
                             {"nodes", stored.map.nodes().size()},
                             {"path_edges", edges.paths},
                             {"loop_edges", edges.loops},
                             {"loops", stored.map.loops()},
                             {"sessions", runs},
                             {"config", config}}));
    return;
  }
  fmt::print(
      "map        {}\nfront end  {}\nimages     {}\nnodes      {}\nedges      {} ({} path, {} loop)\nloops   "
      "   {}\nsessions   {}\n",
      path, stored.frontend, stored.map.images(), stored.map.nodes().size(), edges.paths + edges.loops,
      edges.paths, edges.loops, stored.map.loops(), sessions.size());
  for (const Session& s : sessions) {
    if (s.source.empty()) continue;  // of a map that was not built by a run
    const auto started = static_cast<std::time_t>(s.started);
    fmt::print("           {} images from image {} on, {} skipped, {:.1f} s, {:%Y-%m-%d %H:%M}, {}\n",
               s.images, s.first_image, s.skipped, s.seconds, fmt::localtime(started), s.source);
  }
  fmt::print("parameters {}\n", config.dump());
}

void export_to(const std::string& path, const std::string& format, const std::string& out) {
  const StoredMap stored = load(path);
  if (out.empty()) {
    export_map(stored.map, format, std::cout);
    return;
  }
  write_file(out, [&](std::ostream& stream) { export_map(stored.map, format, stream); });
}

void draw(const std::string& path, const std::string& out) { write_map_plot(out, load(path).map, path); }

// The format that the extension of `out` names, when none was given.
std::string format_for(const std::string& format, const std::string& out) {
  if (!format.empty()) return format;
  const std::string extension = std::filesystem::path(out).extension().string();
  for (const std::string_view known : export_formats()) {
    if (extension == "." + std::string(known)) return std::string(known);
  }
  throw UsageError("say --format, or --out with an extension that names it");
}

}  // namespace

void add_map(CLI::App& app) {
  struct Options {
    std::string file;
    std::string format;
    std::string out;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("map", "Look into a map file, or export it");
  command->require_subcommand(1);
  CLI::App* info_command = command->add_subcommand("info", "Counts and parameters");
  info_command->add_option("FILE", options->file, "The map")->required();
  info_command->add_flag("--json", options->json, "As one line of JSON");
  info_command->callback([options] { info(options->file, options->json); });
  add_map_upkeep(*command);
  CLI::App* export_command = command->add_subcommand("export", "Write the map in another format");
  export_command->add_option("FILE", options->file, "The map")->required();
  std::vector<std::string> formats;
  for (const std::string_view format : export_formats()) formats.emplace_back(format);
  export_command->add_option("--format", options->format, "The format; without, the extension of --out")
      ->check(CLI::IsMember(formats).description(""))
      ->type_name("dot|graphml|g2o|csv|json");
  export_command->add_option("--out", options->out, "Where to; without, standard output")->type_name("FILE");
  export_command->callback(
      [options] { export_to(options->file, format_for(options->format, options->out), options->out); });
  CLI::App* draw_command =
      command->add_subcommand("draw", "Draw the map as a graph, loops coloured by similarity");
  draw_command->add_option("FILE", options->file, "The map")->required();
  draw_command->add_option("--out", options->out, "The drawing")->required()->type_name("OUT.svg");
  draw_command->callback([options] { draw(options->file, options->out); });
}

}  // namespace sailmap::app
