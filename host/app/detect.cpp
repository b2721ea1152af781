// sailmap detect: the salient regions of images, as figure and numbers.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "commands.hpp"
#include "describe_image.hpp"
#include "json_output.hpp"
#include "map/config_json.hpp"
#include "options.hpp"
#include "progress.hpp"
#include "sailmap/figures.hpp"
#include "sailmap/file.hpp"
#include "sailmap/frontend.hpp"
#include "sailmap/image_source.hpp"
#include "sailmap/npy.hpp"
#include "sailmap/number_format.hpp"
#include "sailmap/signature.hpp"

namespace sailmap::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct Options {
  std::vector<std::string> images;
  std::string frontend;
  fs::path out = "sailmap-detect";
  bool save_maps = false;
  bool json = false;
  RegionConfig regions;
};

// One image's results: in `out` itself for a single image, in a folder of its own beneath for several.
std::vector<fs::path> result_folders(const std::vector<std::string>& images, const fs::path& out) {
  if (images.size() == 1) return {out};
  std::vector<fs::path> folders;
  std::set<std::string> taken;
  for (const std::string& image : images) {
    const std::string stem = fs::path(image).stem().string();
    std::string name = stem;
    for (int copy = 2; !taken.insert(name).second; ++copy) name = stem + "-" + std::to_string(copy);
    folders.push_back(out / name);
  }
  return folders;
}

void for_each_map(const Maps& maps, const std::function<void(std::string_view, const Map&)>& visit) {
  for (std::size_t i = 0; i < feature_count; ++i) visit(feature_names[i], maps.features[i]);
  for (std::size_t i = 0; i < conspicuity_count; ++i) visit(conspicuity_names[i], maps.conspicuities[i]);
  visit("saliency", maps.saliency);
}

// How to read the numbers of a map: value = raw * lsb, and for fixed point lsb = unit / 2^fraction.
ordered_json format_of(const Map& map) {
  ordered_json out = {{"format", map.format}, {"lsb", map.lsb}};
  if (const NumberFormat* format = find_number_format(map.format)) {
    out["word"] = format->word;
    out["fraction"] = format->fraction;
    out["signed"] = format->is_signed;
    out["rounding"] = format->rounding;
    out["overflow"] = format->overflow;
    out["unit"] = format->unit;
  }
  return out;
}

void add_statistics(const MapStatistics& statistics, ordered_json& entry) {
  entry["maximum"] = statistics.maximum;
  entry["maxima"] = statistics.maxima;
}

void save_maps(const Maps& maps, const fs::path& folder) {
  ordered_json formats;
  for_each_map(maps, [&](std::string_view name, const Map& map) {
    write_npy(folder / (std::string(name) + ".npy"), map);
    formats[std::string(name)] = format_of(map);
  });
  for (std::size_t i = 0; i < feature_count; ++i) {
    add_statistics(maps.feature_statistics[i], formats[std::string(feature_names[i])]);
  }
  for (std::size_t i = 0; i < conspicuity_count; ++i) {
    add_statistics(maps.conspicuity_statistics[i], formats[std::string(conspicuity_names[i])]);
  }
  write_file(folder / "maps.json", [&](std::ostream& out) { out << formats.dump(2) << '\n'; });
}

ordered_json json_of(const Signature& signature, const std::string& image, const std::string& frontend) {
  const ordered_json regions = to_json(signature);
  return {{"image", image},
          {"width", signature.width},
          {"height", signature.height},
          {"frontend", frontend},
          {"regions", regions.at("regions")}};
}

void save_regions(const ordered_json& json, const fs::path& path) {
  write_file(path, [&](std::ostream& out) {
    out << json.dump(2, ' ', false, ordered_json::error_handler_t::replace) << '\n';
  });
}

void detect_one(const std::string& path, const fs::path& folder, Frontend& frontend, const Options& options) {
  const DescribedImage d = describe_with_maps(path, read_image(path), frontend, options.regions);
  make_folder(folder);
  if (options.save_maps) save_maps(d.maps, folder);
  write_image(folder / "figure.png",
              saliency_figure(d.image, d.maps, d.signature, options.regions.box_side, path));
  ordered_json json = json_of(d.signature, path, options.frontend);
  save_regions(json, folder / "regions.json");
  if (options.json) {
    json["out"] = folder.string();
    print_json(json);
    return;
  }
  fmt::print("{}: {} regions -> {}\n", path, d.signature.regions.size(), (folder / "figure.png").string());
}

void detect(const Options& options) {
  check_signature(options.frontend, options.regions);
  const auto frontend = make_frontend(options.frontend);
  const std::vector<fs::path> folders = result_folders(options.images, options.out);
  Progress progress("detect", static_cast<int>(options.images.size()));
  for (std::size_t i = 0; i < options.images.size(); ++i) {
    progress.clear();
    detect_one(options.images[i], folders[i], *frontend, options);
    progress.step_to(static_cast<int>(i) + 1);
  }
}

}  // namespace

void add_detect(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("detect", "Find the salient regions of images");
  command->add_option("IMAGE", options->images, "Image files")->required();
  add_frontend_option(*command, options->frontend);
  command
      ->add_option(
          "--out", options->out,
          "Folder for figure.png and regions.json; one folder an image beneath it when there are several")
      ->capture_default_str()
      ->type_name("DIR");
  command->add_flag("--save-maps", options->save_maps,
                    "Also each map as NAME.npy, and maps.json with the maps' number formats, max and m");
  add_json_flag(*command, options->json, "Print what regions.json says, one line of JSON an image");
  add_region_options(*command, options->regions);
  command->callback([options] { detect(*options); });
}

}  // namespace sailmap::app
