// What quantisation does to place recognition: average precision of a sequence with each front end.
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "sailmap/signature.hpp"

namespace sailmap::numbers {

// The real sequences, and how many newest images are not compared (spec 11).
struct Sequence {
  const char* name;
  int exclude_recent;
};
inline constexpr std::array<Sequence, 2> sequences = {{{"rtabmap_corridor", 20}, {"gardens_point", 50}}};

// Average precision (spec 12) of the methods of the paper.
struct Recognition {
  double paper = 0;
  double paper_weighted = 0;
};

// `folder` holds images/ and ground_truth.txt. Throws Error when they cannot be read.
Recognition recognise(const std::filesystem::path& folder, int exclude_recent, const std::string& frontend,
                      SignatureMaker signature = SignatureMaker::host);

// The chip's signatures against the host's, of the same fixed-point maps.
struct SignatureDifference {
  int regions = 0;
  int other_regions = 0;     // not at the same place, or of another saliency
  double largest_entry = 0;  // of a descriptor, absolute
};
// Of the images in `folder`. Throws Error when they cannot be read.
SignatureDifference compare_signatures(const std::filesystem::path& folder);

}  // namespace sailmap::numbers
