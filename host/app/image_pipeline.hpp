// Reading, describing and using images side by side on several threads (oneTBB); what is used comes in the
// order of the source, whatever the number of threads.
#pragma once

#include <exception>
#include <functional>
#include <string>

#include "sailmap/image_source.hpp"
#include "sailmap/map_store.hpp"
#include "sailmap/signature.hpp"

namespace sailmap::app {

// One image, described.
struct PipelineImage {
  std::string name;
  Signature signature;
  ImageNote note;
};

struct ImagePipeline {
  std::string frontend;
  RegionConfig regions;
  int thumbnail_width = 0;  // pixels; 0: no thumbnails
  // Whether an image is to be read at all.
  std::function<bool(const std::string& name)> wanted = [](const std::string&) { return true; };
  // Asked before each image is read.
  std::function<bool()> go_on = [] { return true; };
  // Takes the images in order, one at a time; false ends the run.
  std::function<bool(PipelineImage image)> use;
  // Takes, in the same order, what went wrong with an image instead; false ends the run. Default: throws it.
  std::function<bool(const std::exception_ptr& fault)> on_fault =
      [](const std::exception_ptr& fault) -> bool { std::rethrow_exception(fault); };
};

// Until the source ends, or a function of the pipeline says so or throws. Images read ahead but not used are
// dropped.
void run_pipeline(ImageSource& source, const ImagePipeline& pipeline);

}  // namespace sailmap::app
