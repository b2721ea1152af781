// How large a ground truth is, so that its layout can be told before it is read.
#pragma once

#include <filesystem>

namespace sailmap::io {

struct Extent {
  int queries = 0;
  int candidates = 0;
};

// One more than the greatest query and candidate of a text ground truth. Throws as read_text_ground_truth.
Extent text_extent(const std::filesystem::path& path);

// Rows and columns of the one matrix of a MATLAB file. Throws as read_mat_ground_truth.
Extent mat_extent(const std::filesystem::path& path);

}  // namespace sailmap::io
