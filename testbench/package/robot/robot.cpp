// The README's use of the library, on a robot that walks past four coloured walls and comes back to the
// first.
#include <cstdint>
#include <iostream>
#include <random>
#include <sailmap/frontend.hpp>
#include <sailmap/topological_map.hpp>
#include <string>
#include <vector>

namespace {

constexpr int width = 160;
constexpr int height = 120;

// Bright patches on grey, the same for the same wall.
std::vector<std::uint8_t> picture(unsigned wall) {
  std::vector<std::uint8_t> pixels(std::size_t{3} * width * height, 90);
  std::mt19937 random(wall);
  for (int patch = 0; patch < 8; ++patch) {
    const std::size_t left = random() % (width - 12);
    const std::size_t top = random() % (height - 12);
    const std::size_t channel = random() % 3;
    for (std::size_t y = top; y < top + 12; ++y) {
      for (std::size_t x = left; x < left + 12; ++x) pixels[3 * (y * width + x) + channel] = 250;
    }
  }
  return pixels;
}

}  // namespace

int main() {
  const auto frontend = sailmap::make_frontend("reference");
  sailmap::MapConfig config;
  config.detection.threshold = sailmap::default_threshold(config.match.method);
  config.exclude_recent = 1;
  sailmap::TopologicalMap map(config);
  sailmap::Maps maps;
  for (const unsigned wall : {1U, 2U, 3U, 4U, 1U}) {
    const std::vector<std::uint8_t> pixels = picture(wall);
    frontend->compute({width, height, pixels.data(), 3 * width}, maps);
    const auto& update =
        map.add("wall " + std::to_string(wall), sailmap::make_signature(maps, map.config().regions));
    if (update.detection.accepted()) std::cout << "back at node " << update.node << '\n';
  }
  const bool right = map.loops() == 1 && map.active() == 0 && map.nodes().size() == 4;
  return right ? 0 : 1;
}
