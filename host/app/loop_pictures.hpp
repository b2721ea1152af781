// Pictures of the pairs of images behind detections.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sailmap/map_store.hpp"

namespace sailmap::app {

struct PictureOptions {
  std::filesystem::path folder;
  std::filesystem::path images;  // where relative names begin; empty: the working folder
};

// Returns the files written, in the order of `loops`: empty for a detection without a node, and for a pair
// that could not be drawn, which is logged and counted in `failed`. Throws Error when the folder or a picture
// cannot be written.
std::vector<std::string> draw_loops(const StoredMap& stored, const std::vector<const Update*>& loops,
                                    const PictureOptions& options, int& failed);

}  // namespace sailmap::app
