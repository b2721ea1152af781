#include "world.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "canvas.hpp"
#include "random.hpp"
#include "sailmap/error.hpp"
#include "sailmap/image_source.hpp"

namespace sailmap {
namespace {

using namespace simulate;

constexpr double scene_scale = 1.5;     // scene pixels for each image pixel, against jagged edges
constexpr double house_range = 210;     // metres
constexpr double kerbside_range = 110;  // metres
constexpr double range_behind = 12;     // metres
constexpr std::size_t most_photographs = 96;
constexpr int photograph_side = 512;  // pixels

template <class T>
void check_range(const char* name, T value, T least, T most) {
  if (value >= least && value <= most) return;  // not so for NaN
  std::ostringstream message;
  message << "simulation: " << name << " is " << value << ", must be " << least << " .. " << most;
  throw Error(message.str());
}

// At most `most_photographs` of the folder, evenly chosen and made smaller, so that memory stays bounded.
std::vector<cv::Mat> load_photographs(const std::filesystem::path& folder) {
  std::vector<cv::Mat> photographs;
  if (folder.empty()) return photographs;
  const auto paths = list_images(folder.string());
  const std::size_t count = std::min(paths.size(), most_photographs);
  for (std::size_t i = 0; i < count; ++i) {
    cv::Mat photograph = read_image(paths[i * paths.size() / count]);
    const double scale = static_cast<double>(photograph_side) / std::max(photograph.cols, photograph.rows);
    if (scale < 1) {
      const cv::Size size(std::max(1, static_cast<int>(photograph.cols * scale)),
                          std::max(1, static_cast<int>(photograph.rows * scale)));
      cv::resize(photograph, photograph, size, 0, 0, cv::INTER_AREA);
    }
    photographs.push_back(photograph);
  }
  return photographs;
}

// Pixels a metre of the textures: more for larger images.
double texture_density(const SimulationConfig& config) {
  return std::clamp(28 * std::sqrt(config.width / 320.0), 18.0, 56.0);
}

const SimulationConfig& checked(const SimulationConfig& config) {
  check(config);
  return config;
}

}  // namespace

void check(const SimulationConfig& config) {
  check_range("images", config.images, 1, 100'000'000);
  check_range("width", config.width, 64, 4096);
  check_range("height", config.height, 64, 4096);
  check_range("images_per_lap", config.images_per_lap, 2, 100'000);
  check_range("jitter", config.jitter, 0.0, 10.0);
  check_range("lighting", config.lighting, 0.0, 10.0);
  check_range("moving_objects", config.moving_objects, 0, 200);
  check_range("match_radius", config.match_radius, 1e-3, 1e6);
}

double focal_length(const SimulationConfig& config) { return 0.8 * std::max(config.width, config.height); }

Simulator::World::World(const SimulationConfig& given)
    : config(checked(given)),
      drive(config),
      plan(plan_street(drive.route())),
      noise_plate(make_noise_plate(0)),
      sprites(make_sprites()),
      buildings(config.seed, plan, texture_density(config), noise_plate, load_photographs(config.textures)),
      ground(config.seed, plan, texture_density(config), noise_plate),
      kerbside(config.seed, plan, config.moving_objects),
      sky(config.seed) {}

cv::Mat Simulator::World::render(int index) const {
  const CameraPose pose = drive.pose(index);
  const double length = drive.route().length();
  Moment moment;
  moment.along = pose.along;
  moment.lap = pose.lap;
  moment.time = seconds_per_image * index;
  moment.camera = {pose.x, pose.y, pose.z};
  moment.looking = {std::cos(pose.heading), std::sin(pose.heading)};
  moment.lighting =
      make_lighting(config.seed, config.lighting, static_cast<double>(index) / config.images_per_lap);

  const auto until = [&](double range) {
    return pose.along - range_behind + std::min(range_behind + range, length);
  };
  const double first = pose.along - range_behind;
  Scene scene;
  ground.place(first, until(house_range), moment.lighting, scene.solid);
  buildings.place(first, until(house_range), moment, sprites, scene);
  kerbside.place(first, until(kerbside_range), moment, sprites, scene);

  View view;
  view.position = moment.camera;
  view.world_to_camera = View::rotation(pose.heading, pose.pitch, pose.roll);
  const int width = static_cast<int>(std::lround(scene_scale * config.width));
  const int height = static_cast<int>(std::lround(scene_scale * config.height));
  view.focal = focal_length(config) * scene_scale;
  view.centre_x = width / 2.0;
  view.centre_y = height / 2.0;
  Raster raster(width, height, view, moment.lighting.haze);
  raster.paint_solid(std::move(scene.solid));
  sky.paint(raster, moment.lighting);
  raster.paint_blended(std::move(scene.blended));
  return expose(raster.colour(), {config.width, config.height}, moment.lighting,
                hash(config.seed, Subject::noise, index));
}

}  // namespace sailmap
