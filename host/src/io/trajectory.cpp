#include "sailmap/trajectory.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core/quaternion.hpp>
#include <optional>
#include <string>

#include "poses.hpp"
#include "text_lines.hpp"

namespace sailmap {
namespace {

using io::Line;
using io::line_error;

// How far from orthonormal a rotation may be: text has few digits.
constexpr double rotation_tolerance = 1e-3;

cv::Affine3d pose_from(const cv::Quatd& rotation, const cv::Vec3d& position) {
  return {rotation.toRotMat3x3(), position};
}

// All words of a line, which a reader has already found to be numbers.
std::vector<double> numbers_of(const Line& line) {
  std::vector<double> out;
  for (const std::string_view word : io::split_words(line.text)) out.push_back(*io::parse_number(word));
  return out;
}

cv::Quatd unit_quaternion(const std::filesystem::path& path, const Line& line,
                          const std::array<double, 4>& xyzw) {
  const cv::Quatd q(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
  if (std::abs(q.norm() - 1) > rotation_tolerance) {
    throw line_error(path, line, "the quaternion qx qy qz qw is not of length 1");
  }
  return q.normalize();
}

TimedPose kitti_pose(const std::filesystem::path& path, const Line& line) {
  const std::vector<double> n = numbers_of(line);
  const cv::Matx33d rotation(n[0], n[1], n[2], n[4], n[5], n[6], n[8], n[9], n[10]);
  const cv::Matx33d error = rotation * rotation.t() - cv::Matx33d::eye();
  if (cv::norm(error, cv::NORM_INF) > rotation_tolerance || cv::determinant(rotation) < 0) {
    throw line_error(path, line, "the first three columns of the 3 x 4 matrix are no rotation");
  }
  return {pose_from(cv::Quatd::createFromRotMat(rotation).normalize(), {n[3], n[7], n[11]})};
}

TimedPose tum_pose(const std::filesystem::path& path, const Line& line) {
  const std::vector<double> n = numbers_of(line);
  return {pose_from(unit_quaternion(path, line, {n[4], n[5], n[6], n[7]}), {n[1], n[2], n[3]}), n[0]};
}

// The columns of a CSV file beside the position.
class CsvExtras {
 public:
  CsvExtras(const std::filesystem::path& path, const Line& header) : path_(path) {
    for (const std::string_view field : io::split_fields(header.text, ',')) {
      std::string& name = names_.emplace_back(field);
      std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
    }
  }

  [[nodiscard]] TimedPose pose(const Line& line, const Pose& position) const {
    const double z = value(line, {"z", "alt"}).value_or(0);
    TimedPose out{pose_from(rotation(line), {position.x, position.y, z})};
    if (const auto time = value(line, {"time", "timestamp"})) out.time = *time;
    return out;
  }

 private:
  [[nodiscard]] bool has(std::string_view name) const {
    return std::ranges::find(names_, name) != names_.end();
  }

  // Of the first of these columns that there is.
  [[nodiscard]] std::optional<double> value(const Line& line,
                                            std::initializer_list<std::string_view> columns) const {
    for (const std::string_view column : columns) {
      const auto at = std::ranges::find(names_, column);
      if (at == names_.end()) continue;
      const auto fields = io::split_fields(line.text, ',');
      const auto index = static_cast<std::size_t>(at - names_.begin());
      const auto number = index < fields.size() ? io::parse_number(fields[index]) : std::optional<double>();
      if (!number) throw line_error(path_, line, "no number in the column " + std::string(column));
      return number;
    }
    return std::nullopt;
  }

  [[nodiscard]] cv::Quatd rotation(const Line& line) const {
    if (has("qx") && has("qy") && has("qz") && has("qw")) {
      return unit_quaternion(
          path_, line,
          {*value(line, {"qx"}), *value(line, {"qy"}), *value(line, {"qz"}), *value(line, {"qw"})});
    }
    // Beside degrees a heading is a compass's, of whatever unit and direction.
    const bool heading = has("x") && has("y") && has("heading");
    return heading ? cv::Quatd::createFromZRot(*value(line, {"heading"})) : cv::Quatd(1, 0, 0, 0);
  }

  const std::filesystem::path& path_;
  std::vector<std::string> names_;
};

}  // namespace

std::vector<TimedPose> read_trajectory(const std::filesystem::path& path) {
  const std::vector<Pose> positions = read_poses(path);  // finds what is wrong with the numbers
  const std::vector<Line> lines = io::read_lines(path);
  std::vector<TimedPose> out;
  if (lines.front().text.find(',') != std::string::npos) {
    const CsvExtras extras(path, lines.front());
    for (std::size_t i = 0; i < positions.size(); ++i) out.push_back(extras.pose(lines[i + 1], positions[i]));
    return out;
  }
  const bool tum = io::split_words(lines.front().text).size() == 8;
  for (const Line& line : lines) out.push_back(tum ? tum_pose(path, line) : kitti_pose(path, line));
  return out;
}

cv::Vec4d quaternion_of(const cv::Affine3d& pose) {
  const cv::Quatd q = cv::Quatd::createFromRotMat(pose.rotation()).normalize();
  const double sign = q.w < 0 ? -1 : 1;
  constexpr double zero = 0;  // added, it makes -0 a 0
  return {sign * q.x + zero, sign * q.y + zero, sign * q.z + zero, sign * q.w + zero};
}

}  // namespace sailmap
