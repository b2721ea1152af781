// Feature maps made of blobs at known places: what a front end might say of a scene.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "sailmap/maps.hpp"

namespace sailmap::testing {

struct Blob {
  double x, y;  // of the middle of the image, base-level samples
  double radius;
  std::size_t map;
  double strength;
};

// The scene `place`: the same number gives the same blobs, spread well beyond the image so that it can be
// moved.
inline std::vector<Blob> scene_blobs(unsigned place, int count = 260) {
  std::mt19937 random(place);
  const auto part = [&random] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<Blob> blobs;
  for (int i = 0; i < count; ++i) {
    blobs.push_back({240 * part() - 120, 180 * part() - 90, 1.5 + 3 * part(),
                     static_cast<std::size_t>(random() % feature_count), 0.3 + part()});
  }
  return blobs;
}

// The scene seen moved to the right and turned (degrees); maps above `maps` stay flat, as colours in a grey
// image.
inline Maps scene_maps(unsigned place, double right = 0, double degrees = 0, std::size_t maps = feature_count,
                       int width = 160, int height = 120) {
  Maps out;
  out.image_width = 4 * width;
  out.image_height = 4 * height;
  std::vector<Plane<double>> planes(feature_count, Plane<double>(width, height, 0.0));
  Plane<double> saliency(width, height, 0.0);
  const double angle = degrees * 3.14159265358979 / 180;
  const double scale = width / 160.0;
  for (const Blob& blob : scene_blobs(place)) {
    if (blob.map >= maps) continue;
    const double bx = scale * (std::cos(angle) * blob.x - std::sin(angle) * blob.y + right) + width / 2.0;
    const double by = scale * (std::sin(angle) * blob.x + std::cos(angle) * blob.y) + height / 2.0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const double d2 = (x - bx) * (x - bx) + (y - by) * (y - by);
        const double r2 = 2 * blob.radius * blob.radius * scale * scale;
        if (d2 > 12 * r2) continue;
        const double value = blob.strength * std::exp(-d2 / r2);
        planes[blob.map](x, y) += value;
        saliency(x, y) += value;
      }
    }
  }
  for (std::size_t i = 0; i < feature_count; ++i) out.features[i].samples = planes[i];
  out.saliency.samples = saliency;
  return out;
}

}  // namespace sailmap::testing
