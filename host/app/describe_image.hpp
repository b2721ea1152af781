// An image file, read and described, with its name in whatever goes wrong.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "sailmap/frontend.hpp"
#include "sailmap/signature.hpp"

namespace sailmap::app {

struct DescribedImage {
  cv::Mat image;
  Maps maps;
  Signature signature;
};

// As below, reusing the memory of `out`.
void describe_into(const std::string& name, cv::Mat image, Frontend& frontend, const RegionConfig& regions,
                   DescribedImage& out);

// `name` is for messages. Throws Error that names the image.
DescribedImage describe_image(const std::string& name, cv::Mat image, Frontend& frontend,
                              const RegionConfig& regions);
DescribedImage describe_image(const std::string& path, Frontend& frontend, const RegionConfig& regions);
// With its maps, which the front end is asked for once more where its signature comes without.
DescribedImage describe_with_maps(const std::string& name, cv::Mat image, Frontend& frontend,
                                  const RegionConfig& regions);

}  // namespace sailmap::app
