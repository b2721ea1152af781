#include "sailmap/simulator.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <unordered_map>
#include <vector>

#include "random.hpp"
#include "sailmap/error.hpp"
#include "world.hpp"

namespace sailmap {
namespace {

void check_index(int index) {
  if (index < 0)
    throw Error("simulation: image " + std::to_string(index) + " does not exist, the first is 0");
}

// Images by square of the ground, `side` metres wide.
class Grid {
 public:
  explicit Grid(double side) : side_(side) {}

  void add(const SimulatedPose& pose, int image) { cells_[key(cell(pose.x), cell(pose.y))].push_back(image); }

  // Calls visit(image) for all in the pose's square and the eight around it.
  template <class Visit>
  void near(const SimulatedPose& pose, const Visit& visit) const {
    for (std::int64_t dy = -1; dy <= 1; ++dy)
      for (std::int64_t dx = -1; dx <= 1; ++dx)
        if (const auto found = cells_.find(key(cell(pose.x) + dx, cell(pose.y) + dy)); found != cells_.end())
          for (const int image : found->second) visit(image);
  }

 private:
  [[nodiscard]] std::int64_t cell(double coordinate) const {
    return static_cast<std::int64_t>(std::floor(coordinate / side_));
  }
  // Exact: poses are less than 2^31 squares from the origin (see check).
  static std::int64_t key(std::int64_t x, std::int64_t y) { return x * (std::int64_t{1} << 32) + y; }

  double side_;
  std::unordered_map<std::int64_t, std::vector<int>> cells_;
};

}  // namespace

Simulator::Simulator(const SimulationConfig& config) : world_(std::make_unique<World>(config)) {}

Simulator::~Simulator() = default;

cv::Mat Simulator::render(int index) const {
  check_index(index);
  return world_->render(index);
}

SimulatedPose Simulator::pose(int index) const {
  check_index(index);
  const simulate::CameraPose pose = world_->drive.pose(index);
  return {pose.x, pose.y, pose.heading};
}

GroundTruth Simulator::ground_truth() const {
  const int images = world_->config.images;
  const double radius = world_->config.match_radius;
  Grid grid(radius);
  std::vector<SimulatedPose> poses;
  GroundTruth truth;
  truth.matches.resize(static_cast<std::size_t>(images));
  for (int query = 0; query < images; ++query) {
    const SimulatedPose here = pose(query);
    std::vector<int>& matches = truth.matches[static_cast<std::size_t>(query)];
    grid.near(here, [&](int earlier) {
      const SimulatedPose& there = poses[static_cast<std::size_t>(earlier)];
      const double dx = here.x - there.x;
      const double dy = here.y - there.y;
      const double turned = std::remainder(here.heading - there.heading, 2 * std::numbers::pi);
      if (dx * dx + dy * dy <= radius * radius && std::abs(turned) <= std::numbers::pi / 4)
        matches.push_back(earlier);
    });
    std::sort(matches.begin(), matches.end());
    poses.push_back(here);
    grid.add(here, query);
  }
  return truth;
}

}  // namespace sailmap
