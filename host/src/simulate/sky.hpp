// What is behind everything: sky with clouds, a skyline, and the ground far away.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "lighting.hpp"
#include "raster.hpp"

namespace sailmap::simulate {

class Sky {
 public:
  explicit Sky(std::uint64_t seed);
  // Fills what nothing was painted on.
  void paint(Raster& raster, const Lighting& lighting) const;

 private:
  [[nodiscard]] cv::Vec3f colour(double azimuth, double slope, const Lighting& lighting) const;

  cv::Mat1f clouds_;             // azimuth x slope, 0..1
  std::vector<double> skyline_;  // slope (height over distance) by azimuth
};

}  // namespace sailmap::simulate
