#include <libexif/exif-data.h>

#include <memory>
#include <opencv2/core.hpp>
#include <string>

#include "image_decoders.hpp"
#include "sailmap/error.hpp"

namespace sailmap::io {

void check_size(std::int64_t width, std::int64_t height) {
  if (width < 1 || height < 1 || width > max_pixels || height > max_pixels / width) {
    throw Error("image size " + std::to_string(width) + " x " + std::to_string(height) +
                " is not possible here");
  }
}

int exif_orientation(Bytes exif) {
  const std::unique_ptr<ExifData, decltype(&exif_data_unref)> data(
      exif_data_new_from_data(exif.data(), static_cast<unsigned int>(exif.size())), &exif_data_unref);
  if (!data) return 1;
  const ExifEntry* entry = exif_content_get_entry(data->ifd[EXIF_IFD_0], EXIF_TAG_ORIENTATION);
  if (entry == nullptr || entry->format != EXIF_FORMAT_SHORT || entry->size < 2) return 1;
  return exif_get_short(entry->data, exif_data_get_byte_order(data.get()));
}

void make_upright(cv::Mat& image, int orientation) {
  constexpr int upside_down = 0;
  constexpr int mirrored = 1;
  constexpr int both = -1;
  if (orientation >= 5 && orientation <= 8) cv::transpose(image, image);
  switch (orientation) {
    case 2:
    case 6:
      cv::flip(image, image, mirrored);
      break;
    case 3:
    case 7:
      cv::flip(image, image, both);
      break;
    case 4:
    case 8:
      cv::flip(image, image, upside_down);
      break;
    default:
      break;
  }
}

}  // namespace sailmap::io
