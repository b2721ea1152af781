// A map in formats that other programs read.
#pragma once

#include <ostream>
#include <string_view>
#include <vector>

#include "sailmap/topological_map.hpp"
#include "sailmap/trajectory.hpp"

namespace sailmap {

// dot, graphml, g2o, tum, kitti, csv, json. All are text in UTF-8; what is not UTF-8 in the name of an image
// becomes U+FFFD, and so does, in GraphML, a control character that XML does not have.
std::vector<std::string_view> export_formats();

// images, nodes, edges, loops: what a CSV file can hold, a line each (RFC 4180, lines end with LF).
std::vector<std::string_view> csv_tables();

struct ExportOptions {
  // One an image, in their order. tum and kitti need them, g2o takes them; others do not use them.
  std::vector<TimedPose> poses;
  // tum, kitti: where each image was recognised to be, the pose of the first image of its node, instead of
  // its own pose.
  bool at_nodes = false;
  std::string_view table = "images";  // csv
};

// Throws Error for an unknown format or table, when poses are missing or not one an image, and when tum finds
// poses without times.
void export_map(const TopologicalMap& map, std::string_view format, std::ostream& out,
                const ExportOptions& options = {});

}  // namespace sailmap
