// sailmap compare: a fixed-point front end against the exact one, over a whole sequence.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "commands.hpp"
#include "describe_image.hpp"
#include "json_output.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "sailmap/comparison.hpp"
#include "sailmap/error.hpp"
#include "sailmap/figures.hpp"
#include "sailmap/file.hpp"
#include "sailmap/image_source.hpp"

namespace sailmap::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct Options {
  std::string source;
  std::string tested;
  std::string expected;
  fs::path out = "sailmap-compare";
  int max_images = 0;
  bool json = false;
  MapConfig config;
};

// Over all images of the sequence.
struct MapTotals {
  double largest = 0;
  double largest_share = 0;
  double squares_share = 0;  // sum over the images of the squared RMS share
  double lsb = 0;
};

struct Worst {
  std::string name;
  double share = -1;  // largest error of its saliency, of the map's maximum
  cv::Mat image;
  Maps difference;
  Signature signature;
};

struct Totals {
  int images = 0;
  int images_of_other_m = 0;
  int regions = 0;
  int same_regions = 0;
  int near_regions = 0;
  std::array<MapTotals, map_count> maps;
  Worst worst;
};

void add(Totals& totals, const ImageDifference& difference) {
  ++totals.images;
  totals.images_of_other_m += difference.maps_of_other_m > 0 ? 1 : 0;
  totals.regions += difference.regions;
  totals.same_regions += difference.same_regions;
  totals.near_regions += difference.near_regions;
  for (std::size_t i = 0; i < map_count; ++i) {
    MapTotals& total = totals.maps[i];
    const MapDifference& map = difference.maps[i];
    total.largest = std::max(total.largest, map.largest);
    total.largest_share = std::max(total.largest_share, map.largest_share());
    total.squares_share += map.rms_share() * map.rms_share();
    total.lsb = map.lsb;
  }
}

double percent(int some, int all) { return all > 0 ? 100.0 * some / all : 100; }
double rms_share(const MapTotals& map, const Totals& totals) {
  return std::sqrt(map.squares_share / totals.images);
}

ordered_json to_json(const Totals& totals, const LoopAgreement& loops, const Options& options) {
  ordered_json maps;
  for (std::size_t i = 0; i < map_count; ++i) {
    const MapTotals& map = totals.maps[i];
    maps[std::string(map_name(i))] = {
        {"largest_error", map.largest},
        {"largest_error_lsb", map.lsb > 0 ? ordered_json(map.largest / map.lsb) : ordered_json()},
        {"largest_error_share", map.largest_share},
        {"rms_error_share", rms_share(map, totals)}};
  }
  return {{"source", options.source},
          {"frontend", options.tested},
          {"against", options.expected},
          {"images", totals.images},
          {"images_with_other_m", totals.images_of_other_m},
          {"maps", maps},
          {"regions",
           {{"compared", totals.regions},
            {"same", totals.same_regions},
            {"within_one_pixel", totals.near_regions}}},
          {"loops",
           {{"images", loops.images},
            {"same_verdict", loops.same_verdict},
            {"with_best_node", loops.with_best},
            {"same_best_node", loops.same_best},
            {"frontend_loops", loops.tested_loops},
            {"against_loops", loops.expected_loops}}},
          {"worst_image", totals.worst.name},
          {"worst_saliency_error_share", totals.worst.share}};
}

void print(const Totals& totals, const LoopAgreement& loops, const Options& options) {
  fmt::print("{}: {} images, {} against {}\n\n", options.source, totals.images, options.tested,
             options.expected);
  fmt::print("{:<24} {:>14} {:>10} {:>14} {:>12}\n", "map", "largest error", "in LSB", "% of maximum",
             "RMS, %");
  for (std::size_t i = 0; i < map_count; ++i) {
    const MapTotals& map = totals.maps[i];
    fmt::print("{:<24} {:>14.3e} {:>10} {:>14.4f} {:>12.5f}\n", map_name(i), map.largest,
               map.lsb > 0 ? fmt::format("{:.2f}", map.largest / map.lsb) : "-", 100 * map.largest_share,
               100 * rms_share(map, totals));
  }
  fmt::print("\nimages in which an m of eq. 1 differs   {} of {} ({:.1f} %)\n", totals.images_of_other_m,
             totals.images, percent(totals.images_of_other_m, totals.images));
  fmt::print("five most salient regions, same place   {} of {} ({:.1f} %), within a pixel {:.1f} %\n",
             totals.same_regions, totals.regions, percent(totals.same_regions, totals.regions),
             percent(totals.near_regions, totals.regions));
  fmt::print("loop closure, same verdict              {} of {} images ({:.1f} %); {} loops against {}\n",
             loops.same_verdict, loops.images, percent(loops.same_verdict, loops.images), loops.tested_loops,
             loops.expected_loops);
  fmt::print("best node, same place                   {} of {} images ({:.1f} %)\n", loops.same_best,
             loops.with_best, percent(loops.same_best, loops.with_best));
  fmt::print("worst image (saliency)                  {}: {:.3f} % of its maximum -> {}\n", totals.worst.name,
             100 * totals.worst.share, (options.out / "worst.png").string());
}

void keep_if_worst(Worst& worst, DescribedImage&& tested, DescribedImage&& expected,
                   const ImageDifference& difference, const std::string& name) {
  const double share = difference.maps.back().largest_share();
  if (share <= worst.share) return;
  worst = {name, share, expected.image, difference_maps(tested.maps, expected.maps),
           std::move(expected.signature)};
}

Totals compare_images(ImageSource& source, const Options& options, TopologicalMap& tested_map,
                      TopologicalMap& expected_map) {
  const auto tested = make_frontend(options.tested);
  const auto expected = make_frontend(options.expected);
  Totals totals;
  std::optional<int> total = source.size();
  if (options.max_images > 0) total = std::min(total.value_or(options.max_images), options.max_images);
  Progress progress("compare", total);
  while (options.max_images == 0 || totals.images < options.max_images) {
    std::optional<Frame> frame = source.next();
    if (!frame) break;
    DescribedImage a = describe_with_maps(frame->name, frame->image, *tested, options.config.regions);
    DescribedImage b = describe_with_maps(frame->name, frame->image, *expected, options.config.regions);
    const ImageDifference difference = compare_maps(a.maps, b.maps, options.config.regions);
    add(totals, difference);
    tested_map.add(frame->name, a.signature);
    expected_map.add(frame->name, b.signature);
    keep_if_worst(totals.worst, std::move(a), std::move(b), difference, frame->name);
    progress.step_to(totals.images);
  }
  return totals;
}

void compare(const Options& options) {
  const auto source = open_source(options.source);
  TopologicalMap tested(options.config);
  TopologicalMap expected(options.config);
  const Totals totals = compare_images(*source, options, tested, expected);
  if (totals.images == 0) throw Error(options.source + ": no image could be read");
  const LoopAgreement loops = compare_loops(tested, expected);
  make_folder(options.out);
  write_image(options.out / "worst.png",
              saliency_figure(totals.worst.image, totals.worst.difference, totals.worst.signature,
                              options.config.regions.box_side,
                              fmt::format("|{} - {}| of {}: each map's largest difference is white",
                                          options.tested, options.expected, totals.worst.name)));
  const ordered_json json = to_json(totals, loops, options);
  write_file(options.out / "compare.json", [&](std::ostream& out) {
    out << json.dump(2, ' ', false, ordered_json::error_handler_t::replace) << '\n';
  });
  if (options.json) {
    print_json(json);
  } else {
    print(totals, loops, options);
  }
}

}  // namespace

void add_compare(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("compare", "Hold a fixed-point front end against the exact one");
  command->add_option("SOURCE", options->source, "Folder, glob in quotes, list file (.txt), image or video")
      ->required();
  add_frontend_option(*command, options->tested);
  options->tested = "quantised";
  command->get_option("--frontend")->default_str(options->tested);
  options->expected = "reference";
  one_of(command->add_option("--against", options->expected, "What it is held against"), frontend_names())
      ->capture_default_str();
  command
      ->add_option("--out", options->out,
                   "Folder for compare.json and worst.png, the error maps of the worst image")
      ->capture_default_str()
      ->type_name("DIR");
  command
      ->add_option("--max-images", options->max_images,
                   "Stop after so many images; 0: at the end of the source")
      ->check(CLI::NonNegativeNumber.description(""))
      ->capture_default_str();
  add_json_flag(*command, options->json, "Print what compare.json says, as one line of JSON");
  add_map_options(*command, options->config);
  command->callback([options, command] {
    settle_thresholds(*command, options->config);
    for (const std::string& frontend : {options->tested, options->expected}) {
      check_signature(frontend, options->config.regions);
    }
    compare(*options);
  });
}

}  // namespace sailmap::app
