// sailmap simulate: a sequence with exact ground truth.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "progress.hpp"
#include "sailmap/simulator.hpp"

namespace sailmap::app {
namespace {

struct Options {
  std::filesystem::path out;
  SimulationConfig config;
};

void simulate(const Options& options) {
  {
    Progress progress("simulate", options.config.images);
    write_simulation(options.out, options.config, [&](int done) { progress.step_to(done); });
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
  command->callback([options] { simulate(*options); });
}

}  // namespace sailmap::app
