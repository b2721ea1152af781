// Poses: KITTI, TUM and CSV, and the ground truth made of them.
#include <cmath>

#include "matches.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sailmap;
  static fuzz::ForeignFile file(".poses");
  const std::filesystem::path& path = file.hold(data, size);
  fuzz::read_foreign(path, [&] { return holds_poses(path); });
  const auto poses = fuzz::read_foreign(path, [&] { return read_poses(path); });
  if (!poses) return 0;
  fuzz::demand(!poses->empty(), "there is a pose");
  for (const Pose& pose : *poses) {
    fuzz::demand(std::isfinite(pose.x) && std::isfinite(pose.y), "a pose is two finite numbers");
  }
  const int count = static_cast<int>(poses->size());
  const GroundTruth near = ground_truth_from_poses(*poses, *poses, 10, true);
  fuzz::check_matches(near, count, count, true);
  for (std::size_t i = 0; i < near.matches.size(); ++i) {
    for (const int j : near.matches[i]) {
      fuzz::demand(std::ranges::binary_search(near.matches[static_cast<std::size_t>(j)], static_cast<int>(i)),
                   "nearness is mutual");
    }
  }
  const GroundTruthOptions traverses{
      .queries = count, .candidates = count, .same_sequence = false, .radius = 10};
  const auto truth = fuzz::read_foreign(path, [&] { return read_ground_truth(path, path, traverses); });
  fuzz::demand(truth.has_value(), "poses that can be read are a ground truth");
  fuzz::check_matches(*truth, count, count, false);
  return 0;
}
