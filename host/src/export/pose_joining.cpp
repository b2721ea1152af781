// Which pose belongs to which image of a map.
#include <algorithm>
#include <cmath>
#include <string>

#include "io/text_lines.hpp"
#include "sailmap/error.hpp"
#include "sailmap/trajectory.hpp"

namespace sailmap {
namespace {

// Units of Unix times by the digits they have since 2001.
double unit_of(const std::string& stem) {
  const bool whole = stem.find_first_not_of("0123456789") == std::string::npos;
  if (!whole) return 1;
  if (stem.size() == 13) return 1e-3;
  if (stem.size() == 16) return 1e-6;
  if (stem.size() == 19) return 1e-9;
  return 1;
}

// `sorted` by time, not empty.
const TimedPose& nearest(const std::vector<TimedPose>& sorted, double time) {
  const auto after =
      std::ranges::lower_bound(sorted, time, {}, [](const TimedPose& pose) { return pose.time; });
  if (after == sorted.end()) return sorted.back();
  if (after == sorted.begin()) return *after;
  const auto before = after - 1;
  return time - before->time <= after->time - time ? *before : *after;
}

}  // namespace

double time_from_name(const std::string& image) {
  const std::string stem = std::filesystem::path(image).stem().string();
  const auto number = io::parse_number(stem);
  return number ? *number * unit_of(stem) : std::numeric_limits<double>::quiet_NaN();
}

std::vector<TimedPose> join_by_number(const TopologicalMap& map, std::vector<TimedPose> poses) {
  if (poses.size() != static_cast<std::size_t>(map.images())) {
    throw Error(std::to_string(poses.size()) + " poses for " + std::to_string(map.images()) +
                " images of the map");
  }
  return poses;
}

std::vector<TimedPose> join_by_time(const TopologicalMap& map, const std::vector<TimedPose>& poses,
                                    double tolerance) {
  std::vector<TimedPose> sorted = poses;
  for (const TimedPose& pose : sorted) {
    if (std::isnan(pose.time)) throw Error("the poses have no times to join them to images by");
  }
  std::ranges::stable_sort(sorted, {}, &TimedPose::time);
  std::vector<TimedPose> out;
  for (const Update& update : map.history()) {
    const double time = time_from_name(update.name);
    if (std::isnan(time)) throw Error("image " + update.name + ": its name is no time");
    if (sorted.empty() || std::abs(nearest(sorted, time).time - time) > tolerance) {
      throw Error("image " + update.name + ": no pose within " + std::to_string(tolerance) + " s");
    }
    out.push_back(nearest(sorted, time));
  }
  return out;
}

}  // namespace sailmap
