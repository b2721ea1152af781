// A pose graph for g2o, GTSAM, Ceres and their like.
#include <fmt/format.h>

#include <map>
#include <set>
#include <string>
#include <utility>

#include "formats.hpp"

namespace sailmap {
namespace {

// A topological map has no metric positions: path edges are given as unit steps ahead and loops as the same
// place, a start for an optimiser that has odometry to put in.
void write_unit_steps(const TopologicalMap& map, std::ostream& out) {
  constexpr const char* information = "1 0 0 1 0 1";
  for (const Node& node : map.nodes()) out << "VERTEX_SE2 " << node.id << ' ' << node.id << " 0 0\n";
  for (const Edge& edge : map.edges()) {
    out << "EDGE_SE2 " << edge.from << ' ' << edge.to << (edge.kind == EdgeKind::path ? " 1 0 0 " : " 0 0 0 ")
        << information << '\n';
  }
}

std::string numbers(const cv::Affine3d& pose) {
  const cv::Vec3d t = pose.translation();
  const cv::Vec4d q = quaternion_of(pose);
  return fmt::format("{} {} {} {} {} {} {}", t[0], t[1], t[2], q[0], q[1], q[2], q[3]);
}

// b as seen from a.
cv::Affine3d motion_between(const cv::Affine3d& a, const cv::Affine3d& b) {
  const cv::Matx33d back = a.rotation().t();
  return {back * b.rotation(), back * (b.translation() - a.translation())};
}

using Step = std::pair<int, int>;  // from one node to another

// The first image that arrived over an edge. A recognised image stands where its node is, so that the motion
// since the image before it is what the poses know of the edge, loops included: they are the steps by which
// the robot came back. How it came to the first image of a session nobody knows.
std::map<Step, int> arrivals(const TopologicalMap& map) {
  std::map<Step, int> out;
  const std::set<int> starts(map.sessions().begin(), map.sessions().end());
  for (std::size_t i = 1; i < map.history().size(); ++i) {
    if (starts.contains(static_cast<int>(i))) continue;
    out.emplace(Step{map.history()[i - 1].node, map.history()[i].node}, static_cast<int>(i));
  }
  return out;
}

void write_poses(const TopologicalMap& map, const std::vector<TimedPose>& poses, std::ostream& out) {
  // The upper triangle of the 6 x 6 unit matrix, row by row.
  constexpr const char* information = "1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1";
  const auto pose_of = [&poses](int image) { return poses[static_cast<std::size_t>(image)].pose; };
  const auto node_pose = [&](int id) {
    return pose_of(map.nodes()[static_cast<std::size_t>(id)].views.front().image);
  };
  for (const Node& node : map.nodes()) {
    out << "VERTEX_SE3:QUAT " << node.id << ' ' << numbers(node_pose(node.id)) << '\n';
  }
  const std::map<Step, int> arrived = arrivals(map);
  for (const Edge& edge : map.edges()) {
    const auto image = arrived.find({edge.from, edge.to});
    const cv::Affine3d motion = image == arrived.end()
                                    ? motion_between(node_pose(edge.from), node_pose(edge.to))
                                    : motion_between(pose_of(image->second - 1), pose_of(image->second));
    out << "EDGE_SE3:QUAT " << edge.from << ' ' << edge.to << ' ' << numbers(motion) << ' ' << information
        << '\n';
  }
}

}  // namespace

void write_g2o(const TopologicalMap& map, std::ostream& out, const ExportOptions& options) {
  if (options.poses.empty()) {
    write_unit_steps(map, out);
  } else {
    write_poses(map, options.poses, out);
  }
}

}  // namespace sailmap
