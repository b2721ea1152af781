// All images of a source, described on all cores.
#pragma once

#include <string>
#include <vector>

#include "sailmap/ground_truth.hpp"
#include "sailmap/signature.hpp"

namespace sailmap::app {

struct DescribeOptions {
  std::string frontend;
  RegionConfig regions;
  bool oxford = false;  // take the images of one side of an interleaved pair sequence
  Side side = Side::left;
};

struct SourceInfo {
  int images = 0;  // of the chosen side
};

// Counts the images. Throws Error when the source is no list of images or video, or its images do not pair
// up.
SourceInfo inspect_source(const std::string& source, const DescribeOptions& options);

struct DescribedSource {
  std::vector<Signature> signatures;  // in the order of the source
  double images_per_second = 0;
};

// Throws Error when an image cannot be read or differs in size from the first.
DescribedSource describe_source(const std::string& source, const DescribeOptions& options);

}  // namespace sailmap::app
