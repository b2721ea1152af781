// sailmap simulate: a sequence with exact ground truth.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "json_output.hpp"
#include "progress.hpp"
#include "sailmap/simulator.hpp"

namespace sailmap::app {
namespace {

struct Options {
  std::filesystem::path out;
  SimulationConfig config;
  bool json = false;
};

void simulate(const Options& options) {
  {
    Progress progress("simulate", options.config.images);
    write_simulation(options.out, options.config, [&](int done) { progress.step_to(done); });
  }
  if (options.json) {
    print_json({{"out", options.out.string()},
                {"images", options.config.images},
                {"width", options.config.width},
                {"height", options.config.height},
                {"seed", options.config.seed},
                {"source", (options.out / "images").string()},
                {"ground_truth", (options.out / "ground_truth.txt").string()},
                {"poses", (options.out / "poses.txt").string()}});
    return;
  }
  fmt::print("{}: {} images of {}x{}, ground truth, poses\n", options.out.string(), options.config.images,
             options.config.width, options.config.height);
}

}  // namespace

void add_simulate(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  SimulationConfig& c = options->config;
  CLI::App* command =
      app.add_subcommand("simulate", "Make a sequence: a camera driven round a world, with ground truth");
  command
      ->add_option("--out", options->out,
                   "Folder to make: images/, ground_truth.txt, poses.txt (TUM), poses.csv")
      ->required()
      ->type_name("DIR");
  command->add_option("--images", c.images, "How many images")->capture_default_str();
  command->add_option("--seed", c.seed, "Another seed is another world")->capture_default_str();
  command->add_option("--width", c.width, "Pixels")->capture_default_str();
  command->add_option("--height", c.height, "Pixels")->capture_default_str();
  command->add_option("--images-per-lap", c.images_per_lap, "The route is a circuit driven again and again")
      ->capture_default_str();
  command
      ->add_option("--jitter", c.jitter,
                   "Change of viewpoint between laps: 0 none, 1 a careful driver, 3 wild")
      ->capture_default_str();
  command
      ->add_option("--lighting", c.lighting,
                   "Change of brightness, contrast and colour: 0 none, 1 a cloudy day")
      ->capture_default_str();
  command->add_option("--moving-objects", c.moving_objects, "People and vehicles about")
      ->capture_default_str();
  command->add_option("--radius", c.match_radius, "Metres within which two images show the same place")
      ->capture_default_str();
  command->add_option("--textures", c.textures, "Photographs for the facades; procedural ones without")
      ->type_name("DIR");
  add_json_flag(*command, options->json);
  command->callback([options] { simulate(*options); });
}

}  // namespace sailmap::app
