// All images of a source, described on all cores.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sailmap/fabmap.hpp"
#include "sailmap/ground_truth.hpp"
#include "sailmap/signature.hpp"

namespace sailmap::app {

// Which images of a source.
struct Selection {
  bool oxford = false;  // those of one side of an interleaved pair sequence
  Side side = Side::left;
};

// The image files that are selected. Throws Error when the images do not pair up.
std::vector<std::filesystem::path> selected_images(const std::string& source, const Selection& selection);

// Counts the images. Throws Error when the source is no list of images or video, or its images do not pair
// up.
int count_images(const std::string& source, const Selection& selection);

// What is known of each image, in the order of the source.
template <class T>
struct Described {
  std::vector<T> images;
  double images_per_second = 0;
};

// Throws Error when an image cannot be read or differs in size from the first.
Described<Signature> describe_source(const std::string& source, const Selection& selection,
                                     const std::string& frontend, const RegionConfig& regions);

// The visual words of each image. Throws Error when an image cannot be read.
Described<fabmap::Histogram> find_words(const std::string& source, const Selection& selection,
                                        const fabmap::Vocabulary& vocabulary);

}  // namespace sailmap::app
