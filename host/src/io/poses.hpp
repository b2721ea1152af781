// Pose files as they are, before degrees become metres.
#pragma once

#include <filesystem>
#include <vector>

#include "sailmap/ground_truth.hpp"

namespace sailmap::io {

struct Track {
  // Positions in a plane; or, when geographic, x = longitude and y = latitude, WGS84 degrees.
  std::vector<Pose> poses;
  bool geographic = false;
};

// See sailmap::read_poses. Never empty.
Track read_track(const std::filesystem::path& path);

// The track in metres, in the plane that touches the ellipsoid at `origin` (degrees as above); as it is when
// it is not geographic. Two traverses must be given the same origin.
std::vector<Pose> in_plane(const Track& track, const Pose& origin);

}  // namespace sailmap::io
