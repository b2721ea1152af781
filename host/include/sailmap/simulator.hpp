// A camera driven round a world, with exact ground truth: an endless source of sequences.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <opencv2/core/mat.hpp>

#include "sailmap/ground_truth.hpp"

namespace sailmap {

struct SimulationConfig {
  int images = 120;  // 1 .. 100 000 000
  std::uint64_t seed = 1;
  int width = 320;  // 64 .. 4096
  int height = 240;
  // 2 .. 100 000; the route is a closed circuit driven again and again. Images are 1.5 m apart, or more where
  // the circuit would be shorter than 100 m.
  int images_per_lap = 50;
  double jitter = 1;    // viewpoint, 0 .. 10: place, heading, pitch, roll; 0 none, 1 a careful driver, 3 wild
  double lighting = 1;  // 0 .. 10: slow and per-lap changes of light, and the camera's noise; 0 none
  int moving_objects = 6;   // 0 .. 200: people and vehicles on 100 m of street; parked cars change with them
  double match_radius = 3;  // metres (0.001 .. 1 000 000) within which two images show the same place
  std::filesystem::path textures;  // folder of photographs; empty: procedural textures
};

// Exact pose of the camera: metres, radians from the x axis.
struct SimulatedPose {
  double x = 0;
  double y = 0;
  double heading = 0;
};

class Simulator {
 public:
  // Throws Error when the configuration is out of range or the texture folder has no image.
  explicit Simulator(const SimulationConfig& config);
  ~Simulator();
  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;
  Simulator(Simulator&&) = delete;
  Simulator& operator=(Simulator&&) = delete;
  // Image `index` (0 ..; any index, not only below config.images): 8-bit BGR, the same for the same
  // configuration. May be called from several threads at once. Throws Error when the index is below 0.
  [[nodiscard]] cv::Mat render(int index) const;
  [[nodiscard]] SimulatedPose pose(int index) const;
  // Of images 0..config.images-1: earlier images taken within match_radius and 45 degrees of heading.
  [[nodiscard]] GroundTruth ground_truth() const;

 private:
  struct World;
  std::unique_ptr<World> world_;
};

// Writes images/000000.png ..., ground_truth.txt, poses.txt (TUM), poses.csv (x,y,heading) and
// simulation.json to `folder`, which must not hold a sequence already (Error). `progress(done)` is called
// after each image.
void write_simulation(const std::filesystem::path& folder, const SimulationConfig& config,
                      const std::function<void(int done)>& progress);

}  // namespace sailmap
