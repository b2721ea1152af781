#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <utility>

#include "sailmap/error.hpp"
#include "sailmap/ground_truth.hpp"

namespace sailmap {

namespace {

namespace geometry = boost::geometry;
using Point = geometry::model::point<double, 2, geometry::cs::cartesian>;
using Box2 = geometry::model::box<Point>;
using Entry = std::pair<Point, int>;
using Tree = geometry::index::rtree<Entry, geometry::index::rstar<16>>;

Tree tree_of(const std::vector<Pose>& poses) {
  std::vector<Entry> entries;
  entries.reserve(poses.size());
  for (const Pose& pose : poses)
    entries.emplace_back(Point(pose.x, pose.y), static_cast<int>(entries.size()));
  return Tree(entries);  // given all at once, the tree is packed
}

double distance(const Pose& a, const Point& b) { return std::hypot(a.x - b.get<0>(), a.y - b.get<1>()); }

std::vector<int> within(const Tree& tree, const Pose& centre, double radius) {
  const Box2 box(Point(centre.x - radius, centre.y - radius), Point(centre.x + radius, centre.y + radius));
  std::vector<int> found;
  for (auto it = tree.qbegin(geometry::index::intersects(box)); it != tree.qend(); ++it) {
    if (distance(centre, it->first) <= radius) found.push_back(it->second);
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace

GroundTruth ground_truth_from_poses(const std::vector<Pose>& queries, const std::vector<Pose>& candidates,
                                    double radius, bool same_sequence) {
  if (!(radius > 0) || !std::isfinite(radius)) throw Error("radius: must be a number above 0");
  const Tree tree = tree_of(candidates);
  GroundTruth truth;
  for (const Pose& query : queries) {
    std::vector<int> matches = within(tree, query, radius);
    if (same_sequence) std::erase(matches, static_cast<int>(truth.matches.size()));
    truth.matches.push_back(std::move(matches));
  }
  return truth;
}

}  // namespace sailmap
