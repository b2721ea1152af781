#include "describe_image.hpp"

#include <utility>

#include "sailmap/error.hpp"
#include "sailmap/image_source.hpp"
#include "sailmap/xrt.hpp"

namespace sailmap::app {

namespace {

// Names the image in whatever goes wrong with it.
template <class Work>
void with_name(const std::string& name, Work work) {
  try {
    work();
  } catch (const DeviceError&) {
    throw;  // no fault of the image
  } catch (const Error& fault) {
    throw Error(name + ": " + fault.what());
  }
}

}  // namespace

void describe_into(const std::string& name, cv::Mat image, Frontend& frontend, const RegionConfig& regions,
                   DescribedImage& out) {
  out.image = std::move(image);
  with_name(name, [&] { frontend.describe(view_of(out.image), regions, out.maps, out.signature); });
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

DescribedImage describe_with_maps(const std::string& name, cv::Mat image, Frontend& frontend,
                                  const RegionConfig& regions) {
  DescribedImage out = describe_image(name, std::move(image), frontend, regions);
  if (out.maps.empty()) with_name(name, [&] { frontend.compute(view_of(out.image), out.maps); });
  return out;
}

}  // namespace sailmap::app
