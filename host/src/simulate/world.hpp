// The simulated world and its pictures, behind the public class.
#pragma once

#include "buildings.hpp"
#include "drive.hpp"
#include "ground.hpp"
#include "kerbside.hpp"
#include "sailmap/simulator.hpp"
#include "sky.hpp"
#include "sprites.hpp"

namespace sailmap {

// Throws Error naming the member that is out of range.
void check(const SimulationConfig& config);

// Camera constants, in pixels of the image.
double focal_length(const SimulationConfig& config);

struct Simulator::World {
  explicit World(const SimulationConfig& config);
  [[nodiscard]] cv::Mat render(int index) const;

  SimulationConfig config;
  simulate::Drive drive;
  simulate::StreetPlan plan;
  cv::Mat1b noise_plate;
  simulate::Sprites sprites;
  simulate::Buildings buildings;
  simulate::Ground ground;
  simulate::Kerbside kerbside;
  simulate::Sky sky;
};

}  // namespace sailmap
