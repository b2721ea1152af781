// The images that the benchmarks work on.
#pragma once

#include <opencv2/core/mat.hpp>

#include "sailmap/image_source.hpp"
#include "sailmap/simulator.hpp"

namespace sailmap::bench {

// A simulated street of this size, 8-bit BGR: the same on every machine, and as busy as a photograph.
inline cv::Mat image_of_size(int width, int height) {
  SimulationConfig config;
  config.width = width;
  config.height = height;
  return Simulator(config).render(3);
}

// "640x480"
inline std::string size_name(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

struct Size {
  int width, height;
};
inline constexpr Size vga = {640, 480};
inline constexpr Size full_hd = {1920, 1080};

}  // namespace sailmap::bench
