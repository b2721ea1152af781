#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "image_decoders.hpp"
#include "sailmap/error.hpp"

namespace sailmap::io {

namespace {

constexpr std::uint32_t uncompressed = 0;
constexpr std::uint32_t bit_fields = 3;

std::uint32_t little_endian(Bytes file, std::size_t at, std::size_t size) {
  if (at + size > file.size()) throw Error("truncated BMP");
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value |= std::uint32_t{file[at + i]} << (8 * i);
  return value;
}

// What the file header and BITMAPINFOHEADER say (or BITMAPCOREHEADER, of 1990).
struct Header {
  std::int64_t pixels_at = 0;
  std::int64_t width = 0;
  std::int64_t height = 0;
  std::int64_t bits = 0;
  std::uint32_t compression = 0;
  std::int64_t end = 0;  // of the headers and of the palette or masks after them
};

Header read_header(Bytes file) {
  constexpr std::int64_t file_header = 14;
  constexpr std::uint32_t core_header = 12;
  constexpr std::uint32_t info_header = 40;  // and its successors, up to BITMAPV5HEADER
  constexpr std::uint32_t v5_header = 124;
  constexpr std::int64_t masks = 12;
  const std::uint32_t header_size = little_endian(file, 14, 4);
  Header header;
  header.pixels_at = little_endian(file, 10, 4);
  header.end = file_header + header_size;
  if (header_size == core_header) {
    header.width = little_endian(file, 18, 2);
    header.height = little_endian(file, 20, 2);
    header.bits = little_endian(file, 24, 2);
    if (header.bits <= 8) header.end += std::int64_t{3} << header.bits;
    return header;
  }
  const bool known = header_size >= info_header && header_size <= v5_header;
  const std::uint32_t colours = known ? little_endian(file, 46, 4) : 0;
  if (!known || colours > 256) throw Error("damaged BMP: impossible header");
  header.width = static_cast<std::int32_t>(little_endian(file, 18, 4));
  // A negative height says that the rows are stored from the top.
  const auto height = static_cast<std::int32_t>(little_endian(file, 22, 4));
  header.height = height < 0 ? -std::int64_t{height} : height;
  header.bits = little_endian(file, 28, 2);
  header.compression = little_endian(file, 30, 4);
  if (header.bits <= 8) {
    header.end += 4 * (colours == 0 ? std::int64_t{1} << header.bits : colours);
  } else if (header.compression == bit_fields) {
    header.end += masks;
  }
  return header;
}

}  // namespace

// OpenCV decodes, but it prints what it finds wrong, so that is found out first.
cv::Mat decode_bmp(Bytes file) {
  const Header header = read_header(file);
  if (header.compression != uncompressed && header.compression != bit_fields) {
    throw Error("compressed BMP; store it uncompressed");
  }
  check_size(header.width, header.height);
  const std::int64_t row_bytes = (header.width * header.bits + 31) / 32 * 4;
  const std::int64_t end = std::max(header.end, header.pixels_at + row_bytes * header.height);
  if (end > static_cast<std::int64_t>(file.size())) {
    throw Error("truncated BMP");
  }
  const cv::_InputArray encoded(file.data(), static_cast<int>(file.size()));
  cv::Mat image = cv::imdecode(encoded, cv::IMREAD_COLOR);
  if (image.empty()) throw Error("damaged BMP");
  return image;
}

}  // namespace sailmap::io
