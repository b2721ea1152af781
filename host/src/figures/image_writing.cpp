// Pictures into files.
#include <algorithm>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "sailmap/error.hpp"
#include "sailmap/figures.hpp"
#include "sailmap/file.hpp"

namespace sailmap {

void write_image(const std::filesystem::path& path, const cv::Mat& image) {
  const std::string name = path.string();
  if (image.empty()) throw Error(name + ": there is no image to write");
  const std::string extension = path.extension().string();
  if (extension.empty() || !cv::haveImageWriter(name)) {
    throw Error(name + ": no image format is known by the extension '" + extension + "'");
  }
  std::vector<std::uint8_t> bytes;
  bool encoded = false;
  try {
    encoded = cv::imencode(extension, image, bytes);
  } catch (const cv::Exception&) {
    encoded = false;
  }
  if (!encoded) throw Error(name + ": the format '" + extension + "' cannot hold this image");
  write_file(path, [&bytes](std::ostream& out) {
    std::copy(bytes.begin(), bytes.end(), std::ostreambuf_iterator<char>(out));
  });
}

}  // namespace sailmap
