#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "sailmap/error.hpp"
#include "sailmap/figures.hpp"
#include "sailmap/file.hpp"

namespace sailmap {

void write_image(const std::filesystem::path& path, const cv::Mat& image) {
  const std::string extension = path.extension().string();
  std::vector<std::uint8_t> bytes;
  bool encoded = false;
  try {
    encoded = !extension.empty() && cv::imencode(extension, image, bytes);
  } catch (const cv::Exception&) {
    encoded = false;
  }
  if (!encoded)
    throw Error(path.string() + ": no image format is known by the extension '" + extension + "'");
  write_file(path, [&bytes](std::ostream& out) {
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  });
}

}  // namespace sailmap
