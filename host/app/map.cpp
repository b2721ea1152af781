// sailmap map: look into map files and carry them elsewhere.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "commands.hpp"
#include "json_output.hpp"
#include "load_map.hpp"
#include "map/config_json.hpp"
#include "sailmap/figures.hpp"
#include "sailmap/map_store.hpp"

namespace sailmap::app {
namespace {

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
  const StoredMap stored = load_map(path);
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
    print_json({{"map", path},
                {"frontend", stored.frontend},
                {"images", stored.map.images()},
                {"nodes", stored.map.nodes().size()},
                {"path_edges", edges.paths},
                {"loop_edges", edges.loops},
                {"loops", stored.map.loops()},
                {"sessions", runs},
                {"config", config}});
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

void draw(const std::string& path, const std::string& out, bool json) {
  const StoredMap stored = load_map(path);
  write_map_plot(out, stored.map, path);
  if (!json) return;
  print_json({{"map", path},
              {"out", out},
              {"images", stored.map.images()},
              {"nodes", stored.map.nodes().size()},
              {"edges", stored.map.edges().size()},
              {"loops", stored.map.loops()}});
}

}  // namespace

void add_map(CLI::App& app) {
  struct Options {
    std::string file;
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
  add_map_export(*command);
  add_map_diff(*command);
  CLI::App* draw_command =
      command->add_subcommand("draw", "Draw the map as a graph, loops coloured by similarity");
  draw_command->add_option("FILE", options->file, "The map")->required();
  draw_command->add_option("--out", options->out, "The drawing")->required()->type_name("OUT.svg");
  add_json_flag(*draw_command, options->json, "Say what was drawn, as one line of JSON");
  draw_command->callback([options] { draw(options->file, options->out, options->json); });
}

}  // namespace sailmap::app
