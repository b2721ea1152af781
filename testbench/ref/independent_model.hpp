// The model of testbench/independent/spec_model.py: made in Python from the specification alone.
#pragma once

#include <filesystem>
#include <map>
#include <opencv2/core.hpp>
#include <string>

namespace sailmap::testing {

struct IndependentModel {
  std::map<std::string, cv::Mat> maps;  // CV_64F by name: ten features, three conspicuities, saliency
  std::map<std::string, int> maxima;    // m by name, of features and conspicuities
};

// True when this build knows a Python that can run it.
bool has_independent_model();

// Runs it on an image file; `folder` takes its results. Throws std::runtime_error when it fails.
IndependentModel run_independent_model(const std::filesystem::path& image,
                                       const std::filesystem::path& folder);

}  // namespace sailmap::testing
