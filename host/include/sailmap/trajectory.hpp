// Where the images of a map were taken: whole poses, joined to the images.
#pragma once

#include <filesystem>
#include <limits>
#include <opencv2/core/affine.hpp>
#include <string>
#include <vector>

#include "sailmap/topological_map.hpp"

namespace sailmap {

struct TimedPose {
  cv::Affine3d pose;                                       // from the camera's frame to the file's
  double time = std::numeric_limits<double>::quiet_NaN();  // seconds; NaN when the file has no times
};

// KITTI (12 numbers a line, the rows of [R t]), TUM (`time x y z qx qy qz qw`), or CSV with a header that
// names x,y or lat,lon (then metres in the plane that touches the first position) and may name z or alt, time
// or timestamp (seconds), qx,qy,qz,qw, or beside x,y heading (radians from x towards y); told apart by
// content. What a CSV file does not say of height and orientation is 0 and none. Rotations come out
// orthonormal. Throws Error naming file, line and fault; a rotation off by more than 1e-3 is a fault.
std::vector<TimedPose> read_trajectory(const std::filesystem::path& path);

// x, y, z, w of unit length, w not negative.
cv::Vec4d quaternion_of(const cv::Affine3d& pose);

// The pose file has as many poses as the map has images, in their order. Throws Error otherwise.
std::vector<TimedPose> join_by_number(const TopologicalMap& map, std::vector<TimedPose> poses);

// Each image gets the pose nearest to its time, which its file name (without folder and extension) tells:
// seconds, or of whole numbers of 13, 16 and 19 digits milli-, micro- and nanoseconds. Throws Error when the
// poses have no times, and naming the image when its name is no time or no pose is within `tolerance`
// seconds.
std::vector<TimedPose> join_by_time(const TopologicalMap& map, const std::vector<TimedPose>& poses,
                                    double tolerance);

// Seconds, as above; NaN when the name is no time.
double time_from_name(const std::string& image);

}  // namespace sailmap
