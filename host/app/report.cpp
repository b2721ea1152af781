// sailmap report: a map or an evaluation as one HTML page.
#include "sailmap/report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "commands.hpp"
#include "io/file_reading.hpp"
#include "json_output.hpp"
#include "sailmap/error.hpp"
#include "sailmap/map_store.hpp"

namespace sailmap::app {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string input;
  fs::path out;
  std::string ground_truth;
  double radius = 0;
  fs::path poses;
  double budget = 8;  // MB
  bool json = false;
  ReportOptions report;
};

// What `eval --json` writes is a JSON object that is no map of old, which says so in its first key.
bool is_evaluation(const std::string& path) {
  std::ifstream in = io::open_for_reading(path);
  const auto bytes = io::read_bytes(in, path, 200);
  const std::string_view start = io::as_text(bytes);
  const std::size_t first = start.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && start[first] == '{' &&
         start.find("\"sailmap map\"") == std::string_view::npos;
}

void report_map(Options& options) {
  const MapStore store(options.input);
  if (!store.exists()) throw Error(options.input + ": no such file, or an empty one");
  const StoredMap stored = store.load();
  options.report.store = &store;
  const int images = stored.map.images();
  if (!options.poses.empty()) options.report.positions = read_poses(options.poses);
  if (!options.ground_truth.empty()) {
    GroundTruthOptions truth;
    truth.queries = images;
    truth.candidates = images;
    truth.radius = options.radius;
    options.report.truth = read_ground_truth(options.ground_truth, truth);
  }
  write_report(options.out, stored.map, stored.frontend, options.report);
}

void report_evaluation(const Options& options) {
  if (!options.poses.empty() || !options.ground_truth.empty()) {
    throw UsageError("--poses and --ground-truth are for maps; an evaluation has its ground truth in it");
  }
  write_evaluation_report(options.out, options.input, options.report);
}

void report(Options& options) {
  options.report.budget = static_cast<std::size_t>(options.budget * 1e6);
  if (options.report.title.empty()) options.report.title = options.input;
  if (is_evaluation(options.input)) {
    if (options.report.title == options.input) options.report.title.clear();
    report_evaluation(options);
  } else {
    report_map(options);
  }
  const auto bytes = fs::file_size(options.out);
  if (options.json) return print_json({{"out", options.out.string()}, {"bytes", bytes}});
  fmt::print("{}: {:.1f} MB\n", options.out.string(), static_cast<double>(bytes) / 1e6);
}

void add_picture_options(CLI::App& command, Options& options) {
  constexpr const char* group = "Pictures";
  ReportOptions& report = options.report;
  command
      .add_option("--pairs", report.pairs, "Loops shown as pictures, at most: strongest, weakest, doubtful")
      ->check(CLI::Range(0, 100000).description(""))
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--image", report.images, "Show the saliency of this image in any case; may be repeated")
      ->type_name("NUMBER")
      ->group(group);
  command
      .add_option("--thumbnails", report.thumbnails,
                  "Further images shown, evenly over the sequence, at most")
      ->check(CLI::Range(0, 100000).description(""))
      ->capture_default_str()
      ->group(group);
  command.add_option("--budget", options.budget, "Megabytes of pictures on the page, at most")
      ->check(CLI::Range(0.0, 1000.0).description(""))
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--image-root", report.image_root,
                  "Where to look for image files that are not where their names say")
      ->type_name("DIR")
      ->group(group);
}

}  // namespace

void add_report(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("report", "Show a map or an evaluation as one HTML page");
  command->add_option("FILE", options->input, "A map, or what `sailmap eval --json` wrote")->required();
  command->add_option("-o,--out", options->out, "The page")->required()->type_name("OUT.html");
  command->add_option("--title", options->report.title, "The page's title; without, what it is of");
  constexpr const char* group = "Of a map";
  command
      ->add_option("--ground-truth", options->ground_truth,
                   "Which images show the same place, as for `sailmap eval`: precision and recall")
      ->type_name("FILE")
      ->group(group);
  command
      ->add_option("--radius", options->radius,
                   "For ground truth by poses: metres within which two images show the same place")
      ->check(CLI::PositiveNumber.description(""))
      ->group(group);
  command
      ->add_option("--poses", options->poses,
                   "Where each image was taken (KITTI, TUM, CSV): a map over positions")
      ->type_name("FILE")
      ->group(group);
  add_picture_options(*command, *options);
  add_json_flag(*command, options->json);
  command->callback([options] { report(*options); });
}

}  // namespace sailmap::app
