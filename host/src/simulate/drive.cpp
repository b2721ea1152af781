#include "drive.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "random.hpp"

namespace sailmap::simulate {
namespace {

constexpr double spacing_wanted = 1.5;    // metres between images
constexpr double shortest_circuit = 100;  // metres; less would leave no room for houses inside
constexpr double camera_height = 1.5;     // metres
constexpr double base_pitch = 0.07;       // radians: more houses, less street

double circuit_length(const SimulationConfig& config) {
  return std::max(shortest_circuit, spacing_wanted * config.images_per_lap);
}

// A driver sways slowly; the mount shakes from image to image. In -1..1, mostly smaller.
double sway(std::uint64_t seed, Subject subject, int index) {
  const double slow = smooth_noise(hash(seed, subject, 1), index / 14.0);
  const double quick = smooth_noise(hash(seed, subject, 2), index);
  return 0.8 * slow + 0.2 * quick;
}

}  // namespace

Drive::Drive(const SimulationConfig& config)
    : seed_(config.seed),
      images_per_lap_(config.images_per_lap),
      jitter_(config.jitter),
      route_(config.seed, circuit_length(config), 1.35 * front_distance(circuit_length(config))) {}

CameraPose Drive::pose(int index) const {
  const StreetPlan plan = plan_street(route_);
  const auto swayed = [&](Subject subject, double most) {
    return jitter_ * most * sway(seed_, subject, index);
  };
  CameraPose pose;
  pose.lap = index / images_per_lap_;
  const double place = spacing() * (index % images_per_lap_) + swayed(Subject::along, 0.5);
  const double lane = plan.wide ? -0.2 * plan.kerb : 0;
  const double room = plan.kerb - 0.6;  // even a wild driver stays off the pavement
  const double lateral = std::clamp(lane + swayed(Subject::lateral, 0.6), -room, room);
  const RoutePoint here = route_.at(place);
  const cv::Vec3d position = here.beside(lateral, camera_height);
  pose.x = position[0];
  pose.y = position[1];
  pose.z = position[2];
  pose.heading = std::remainder(here.heading + swayed(Subject::heading, 0.06), 2 * std::numbers::pi);
  pose.pitch = base_pitch + swayed(Subject::pitch, 0.02);
  pose.roll = swayed(Subject::roll, 0.02);
  pose.along = place;
  return pose;
}

}  // namespace sailmap::simulate
