// The images of a source, described side by side and handed on in order, until the source ends, the user
// interrupts (SIGINT, SIGTERM) or enough were used.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "image_pipeline.hpp"
#include "progress.hpp"
#include "run_report.hpp"
#include "sailmap/image_source.hpp"

namespace sailmap::app {

struct SourceRun {
  std::string frontend;
  RegionConfig regions;
  int max_images = 0;  // 0: all
  bool skip_bad = false;
  int thumbnail_width = 0;
  std::function<bool(const std::string& name)> wanted = [](const std::string&) { return true; };
  // Takes one image; `progress` is to be cleared before anything is printed.
  std::function<void(PipelineImage image, Progress& progress)> use;
};

// `counts` is kept up to date, but for the loops. Throws Error when an image cannot be read and is not to be
// skipped. Afterwards the source's early end, if there was one, has been told.
void run_source(ImageSource& source, const SourceRun& run, RunCounts& counts);

}  // namespace sailmap::app
