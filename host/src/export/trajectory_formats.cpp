// TUM and KITTI: the pose of every image of the map, a line each.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "formats.hpp"
#include "sailmap/error.hpp"

namespace sailmap {
namespace {

// The poses a trajectory is made of, by image, with the time of the image itself.
std::vector<TimedPose> trajectory_of(const TopologicalMap& map, const ExportOptions& options,
                                     const char* format) {
  if (map.images() > 0 && options.poses.empty()) {
    throw Error(std::string("a map has no positions: ") + format + " needs poses");
  }
  std::vector<TimedPose> out = options.poses;
  if (!options.at_nodes) return out;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Node& node = map.nodes()[static_cast<std::size_t>(map.history()[i].node)];
    out[i].pose = options.poses[static_cast<std::size_t>(node.views.front().image)].pose;
  }
  return out;
}

}  // namespace

void write_tum(const TopologicalMap& map, std::ostream& out, const ExportOptions& options) {
  for (const TimedPose& timed : trajectory_of(map, options, "tum")) {
    if (std::isnan(timed.time)) throw Error("the poses have no times, which tum needs");
    const cv::Vec3d t = timed.pose.translation();
    const cv::Vec4d q = quaternion_of(timed.pose);
    out << fmt::format("{} {} {} {} {} {} {} {}\n", timed.time, t[0], t[1], t[2], q[0], q[1], q[2], q[3]);
  }
}

void write_kitti(const TopologicalMap& map, std::ostream& out, const ExportOptions& options) {
  for (const TimedPose& timed : trajectory_of(map, options, "kitti")) {
    const cv::Matx44d& m = timed.pose.matrix;
    for (int i = 0; i < 12; ++i) out << fmt::format("{}{}", i == 0 ? "" : " ", m(i / 4, i % 4));
    out << '\n';
  }
}

}  // namespace sailmap
