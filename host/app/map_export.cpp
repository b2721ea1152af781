// sailmap map export: the map in formats that other programs read.
#include "sailmap/map_export.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "commands.hpp"
#include "json_output.hpp"
#include "load_map.hpp"
#include "options.hpp"
#include "sailmap/error.hpp"
#include "sailmap/file.hpp"

namespace sailmap::app {
namespace {

struct Options {
  std::string file;
  std::string format;
  std::string out;
  std::string table = "images";
  std::string poses;
  std::string join = "number";
  double tolerance = 0.02;
  double rate = 0;
  bool at_nodes = false;
  bool json = false;
};

// The format that the extension of `out` names, when none was given.
std::string format_for(const std::string& format, const std::string& out) {
  if (!format.empty()) return format;
  const std::string extension = std::filesystem::path(out).extension().string();
  for (const std::string_view known : export_formats()) {
    if (extension == "." + std::string(known)) return std::string(known);
  }
  throw UsageError("say --format, or --out with an extension that names it");
}

void check(const Options& options, const CLI::App& command) {
  const std::set<std::string> trajectories = {"tum", "kitti"};
  const bool trajectory = trajectories.contains(options.format);
  if (trajectory && options.poses.empty()) {
    throw UsageError(options.format + " needs --poses: a map has no positions of its own");
  }
  if (!options.poses.empty() && !trajectory && options.format != "g2o") {
    throw UsageError("--poses goes with the formats g2o, tum and kitti");
  }
  if (options.at_nodes && !trajectory) throw UsageError("--at-nodes goes with the formats tum and kitti");
  if (command.get_option("--table")->count() > 0 && options.format != "csv") {
    throw UsageError("--table goes with the format csv");
  }
  for (const char* name : {"--join", "--time-tolerance", "--rate"}) {
    if (command.get_option(name)->count() > 0 && options.poses.empty()) {
      throw UsageError(std::string(name) + " goes with --poses");
    }
  }
  if (options.json && options.out.empty()) throw UsageError("--json goes with --out");
}

void set_times(std::vector<TimedPose>& poses, double rate) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!std::isnan(poses[i].time)) throw Error("the poses have times; --rate is for those without");
    poses[i].time = static_cast<double>(i) / rate;
  }
}

std::vector<TimedPose> poses_for(const TopologicalMap& map, const Options& options) {
  try {
    std::vector<TimedPose> poses = read_trajectory(options.poses);
    if (options.rate > 0) set_times(poses, options.rate);
    return options.join == "time" ? join_by_time(map, poses, options.tolerance)
                                  : join_by_number(map, std::move(poses));
  } catch (const Error& fault) {
    const std::string text = fault.what();
    throw text.starts_with(options.poses) ? fault : Error(options.poses + ": " + text);
  }
}

void export_to(const Options& options) {
  const StoredMap stored = load_map(options.file);
  ExportOptions how;
  how.at_nodes = options.at_nodes;
  how.table = options.table;
  if (!options.poses.empty()) how.poses = poses_for(stored.map, options);
  if (options.format == "tum" && !how.poses.empty() && std::isnan(how.poses.front().time)) {
    throw Error(options.poses + ": the poses have no times, which tum needs; say --rate");
  }
  if (options.out.empty()) {
    export_map(stored.map, options.format, std::cout, how);
    return;
  }
  write_file(options.out, [&](std::ostream& stream) { export_map(stored.map, options.format, stream, how); });
  if (!options.json) return;
  print_json({{"map", options.file},
              {"format", options.format},
              {"out", options.out},
              {"images", stored.map.images()},
              {"nodes", stored.map.nodes().size()},
              {"edges", stored.map.edges().size()},
              {"loops", stored.map.loops()}});
}

void add_pose_options(CLI::App& command, Options& options) {
  constexpr const char* group = "Poses (formats g2o, tum and kitti)";
  command
      .add_option(
          "--poses", options.poses,
          "Where the images were taken: KITTI, TUM, or CSV with x,y or lat,lon; g2o without it has unit "
          "steps for path edges and no motion for loops")
      ->type_name("FILE")
      ->group(group);
  one_of(command.add_option("--join", options.join,
                            "How poses belong to images: by number, one pose an image in their order, or by "
                            "time, which the images' file names tell (seconds; whole numbers of 13, 16, 19 "
                            "digits: milli-, micro-, nanoseconds)"),
         {"number", "time"})
      ->capture_default_str()
      ->group(group);
  command.add_option("--time-tolerance", options.tolerance, "Seconds between image and pose, at most")
      ->check(CLI::NonNegativeNumber.description(""))
      ->capture_default_str()
      ->group(group);
  command.add_option("--rate", options.rate, "Images a second, for poses without times; tum needs times")
      ->check(CLI::PositiveNumber.description(""))
      ->group(group);
  command
      .add_flag(
          "--at-nodes", options.at_nodes,
          "tum, kitti: where each image was recognised to be (the pose of its node) instead of its own pose")
      ->group(group);
}

}  // namespace

void add_map_export(CLI::App& map) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = map.add_subcommand("export", "Write the map in another format");
  command->add_option("FILE", options->file, "The map")->required();
  one_of(command->add_option("--format", options->format, "The format; without, the extension of --out"),
         to_strings(export_formats()));
  command->add_option("--out", options->out, "Where to; without, standard output")->type_name("FILE");
  one_of(
      command->add_option("--table", options->table,
                          "csv: a line for each of the images, nodes, edges, or loops (accepted detections)"),
      to_strings(csv_tables()))
      ->capture_default_str();
  add_json_flag(*command, options->json, "With --out: say what was written, as one line of JSON");
  add_pose_options(*command, *options);
  command->callback([options, command] {
    options->format = format_for(options->format, options->out);
    check(*options, *command);
    export_to(*options);
  });
}

}  // namespace sailmap::app
