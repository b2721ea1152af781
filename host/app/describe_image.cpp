#include "describe_image.hpp"

#include <utility>

#include "sailmap/error.hpp"
#include "sailmap/image_source.hpp"
#include "sailmap/xrt.hpp"

namespace sailmap::app {

void describe_into(const std::string& name, cv::Mat image, Frontend& frontend, const RegionConfig& regions,
                   DescribedImage& out) {
  out.image = std::move(image);
  try {
    frontend.describe(view_of(out.image), regions, out.maps, out.signature);
  } catch (const DeviceError&) {
    throw;  // no fault of the image
  } catch (const Error& fault) {
    throw Error(name + ": " + fault.what());
  }
}

DescribedImage describe_image(const std::string& name, cv::Mat image, Frontend& frontend,
                              const RegionConfig& regions) {
  DescribedImage out;
  describe_into(name, std::move(image), frontend, regions, out);
  return out;
}

DescribedImage describe_image(const std::string& path, Frontend& frontend, const RegionConfig& regions) {
  return describe_image(path, read_image(path), frontend, regions);
}

}  // namespace sailmap::app
