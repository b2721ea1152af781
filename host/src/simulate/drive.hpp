// Where the camera is and looks at each image: once round the route every `images_per_lap` images.
#pragma once

#include <cstdint>

#include "route.hpp"
#include "sailmap/simulator.hpp"
#include "street_plan.hpp"

namespace sailmap::simulate {

inline constexpr double seconds_per_image = 0.5;

struct CameraPose {
  double x = 0;  // metres
  double y = 0;
  double z = 0;        // above the ground
  double heading = 0;  // radians from the x axis, -pi .. pi
  double pitch = 0;    // radians, up positive
  double roll = 0;     // radians, clockwise seen from behind the camera
  double along = 0;    // metres along the route within the lap
  std::int64_t lap = 0;
};

class Drive {
 public:
  explicit Drive(const SimulationConfig& config);
  [[nodiscard]] CameraPose pose(int index) const;
  [[nodiscard]] const Route& route() const { return route_; }
  // Metres between images when nobody jitters.
  [[nodiscard]] double spacing() const { return route_.length() / images_per_lap_; }

 private:
  std::uint64_t seed_;
  int images_per_lap_;
  double jitter_;
  Route route_;
};

}  // namespace sailmap::simulate
