// What the camera may see at one moment, as surfaces.
#pragma once

#include <cstdint>
#include <vector>

#include "lighting.hpp"
#include "raster.hpp"
#include "sprites.hpp"

namespace sailmap::simulate {

// When and where the scene is asked for.
struct Moment {
  double along = 0;  // metres along the route within the lap, 0 .. its length
  std::int64_t lap = 0;
  double time = 0;  // seconds
  cv::Vec3d camera;
  cv::Vec2d looking;  // unit vector on the ground
  Lighting lighting;

  // True when the point is behind the camera.
  [[nodiscard]] bool behind(const cv::Vec3d& point) const {
    return (point[0] - camera[0]) * looking[0] + (point[1] - camera[1]) * looking[1] < 0;
  }
};

struct Scene {
  std::vector<Surface> solid, blended;
};

// The sprite upright on the ground, facing the camera, and its shadow.
void place_sprite(Scene& scene, const Sprite& sprite, const cv::Vec3d& position, const Moment& moment,
                  bool mirrored, const Sprite& soft_shadow);

}  // namespace sailmap::simulate
