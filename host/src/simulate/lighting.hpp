// The light of one image: sun, clouds, air, and what the camera makes of it.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/matx.hpp>

#include "raster.hpp"

namespace sailmap::simulate {

// Colours in B, G, R.
struct Lighting {
  cv::Vec3d to_sun;        // unit vector
  cv::Vec3f ambient, sun;  // a surface shows ambient + sun * cosine of its colour
  float shadow = 0.4F;     // opacity of shadows on the ground
  Haze haze;
  cv::Vec3f zenith, horizon;
  double clouds = 0.5;     // part of the sky
  double cloud_shift = 0;  // radians the clouds have drifted
  cv::Vec3f gain = {1, 1, 1};
  float contrast = 1;
  float noise = 0;  // standard deviation, grey levels

  // The factor for a surface with that unit normal.
  [[nodiscard]] cv::Vec3f on(const cv::Vec3d& normal) const;
};

// After `laps` laps (whole and part). `amount` scales all that changes, the camera's noise among it; with 0
// the light is that of the seed for ever.
Lighting make_lighting(std::uint64_t seed, double amount, double laps);

// What the camera delivers of what it sees: shrunk to `size`, exposed, darkened towards the corners, with
// noise of the given seed.
cv::Mat3b expose(const cv::Mat3b& scene, cv::Size size, const Lighting& lighting, std::uint64_t noise_seed);

}  // namespace sailmap::simulate
