// Trajectories (KITTI, TUM, CSV with orientation): what can be read are finite positions and proper
// rotations, which are the same when written for another program and read again.
#include <cmath>
#include <opencv2/core.hpp>

#include "foreign_file.hpp"
#include "sailmap/trajectory.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sailmap;
  static fuzz::ForeignFile file(".trajectory");
  const std::filesystem::path& path = file.hold(data, size);
  const auto poses = fuzz::read_foreign(path, [&] { return read_trajectory(path); });
  if (!poses) return 0;
  fuzz::demand(!poses->empty(), "there is a pose");
  for (const TimedPose& pose : *poses) {
    fuzz::demand(cv::checkRange(pose.pose.matrix), "a pose is finite");
    const cv::Matx33d rotation = pose.pose.rotation();
    fuzz::demand(cv::norm(rotation * rotation.t() - cv::Matx33d::eye()) < 1e-6, "a rotation is orthonormal");
    fuzz::demand(cv::determinant(rotation) > 0, "a rotation is no mirror");
    const cv::Vec4d quaternion = quaternion_of(pose.pose);
    fuzz::demand(std::abs(cv::norm(quaternion) - 1) < 1e-6 && quaternion[3] >= 0,
                 "a quaternion has length 1");
  }
  return 0;
}
