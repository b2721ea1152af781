// Frames from binary PPM files (P6, 8 bits).
#pragma once

#include <cstddef>
#include <fstream>
#include <stdexcept>
#include <string>

#include "sailmap/csim/frame.hpp"

namespace sailmap::testing {

// Throws std::runtime_error that names the file when it is no such file.
inline csim::Frame read_ppm(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string magic;
  int width = 0;
  int height = 0;
  int most = 0;
  file >> magic >> width >> height >> most;
  file.get();
  if (!file || magic != "P6" || most != 255 || width < 1 || height < 1 || width > 4096 || height > 4096) {
    throw std::runtime_error(path + ": not a binary PPM of 8 bits");
  }
  csim::Frame frame{width, height, {}};
  frame.rgb.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  file.read(reinterpret_cast<char*>(frame.rgb.data()), static_cast<std::streamsize>(frame.rgb.size()));
  if (!file) throw std::runtime_error(path + ": too short");
  return frame;
}

}  // namespace sailmap::testing
