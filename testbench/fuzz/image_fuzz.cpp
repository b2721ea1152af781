// Images: JPEG, PNG, TIFF, WebP, BMP and PNM, told apart by content.
#include <opencv2/core.hpp>

#include "foreign_file.hpp"
#include "sailmap/image_source.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sailmap;
  constexpr std::size_t most_pixels = std::size_t{1} << 28U;
  constexpr std::size_t quickly_summed = std::size_t{1} << 20U;
  static fuzz::ForeignFile file(".image");
  const std::filesystem::path& path = file.hold(data, size);
  const auto image = fuzz::read_foreign(path, [&] { return read_image(path); });
  if (!image) return 0;
  fuzz::demand(image->type() == CV_8UC3 && image->dims == 2, "an image is 8-bit BGR");
  fuzz::demand(image->total() >= 1 && image->total() <= most_pixels, "an image has pixels, and not too many");
  // Every pixel is there, and not from memory that was never written: the same file, the same pixels.
  if (image->total() > quickly_summed) return 0;
  fuzz::demand(cv::norm(*image, read_image(path), cv::NORM_INF) == 0, "an image is the same when read again");
  return 0;
}
