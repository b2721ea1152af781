// Images whose metadata say how the camera was held are turned upright, as cv::imread turns them.
#include <gmock/gmock.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "sailmap/image_source.hpp"
#include "temporary_folder.hpp"
#include "test_images.hpp"

namespace sailmap {
namespace {

using testing::alike;

std::string little_endian(unsigned value, int size) {
  std::string bytes;
  for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
  return bytes;
}

// An entry of a TIFF directory: one unsigned number of 16 (type 3) or 32 bits (type 4).
std::string tiff_entry(unsigned tag, unsigned type, unsigned value) {
  return little_endian(tag, 2) + little_endian(type, 2) + little_endian(1, 4) + little_endian(value, 4);
}

// A TIFF header and a directory that holds the orientation alone: EXIF is a TIFF without an image.
std::string exif_block(unsigned orientation) {
  return std::string("II*\0", 4) + little_endian(8, 4) + little_endian(1, 2) +
         tiff_entry(274, 3, orientation) + little_endian(0, 4);
}

std::string jpeg_with_orientation(const cv::Mat& image, unsigned orientation) {
  std::vector<unsigned char> encoded;
  cv::imencode(".jpg", image, encoded);
  std::string jpeg(encoded.begin(), encoded.end());
  const std::string payload = std::string("Exif\0\0", 6) + exif_block(orientation);
  const auto length = static_cast<unsigned>(payload.size() + 2);
  const std::string segment = std::string("\xFF\xE1\0", 3) + static_cast<char>(length) + payload;
  return jpeg.insert(2, segment);
}

std::string big_endian(std::uint32_t value) {
  std::string bytes = little_endian(value, 4);
  std::ranges::reverse(bytes);
  return bytes;
}

// An eXIf chunk after the header chunk: length, name, data, and the checksum of the last two.
std::string png_with_orientation(const cv::Mat& image, unsigned orientation) {
  constexpr std::size_t after_header = 8 + 25;
  std::vector<unsigned char> encoded;
  cv::imencode(".png", image, encoded);
  std::string png(encoded.begin(), encoded.end());
  const std::string chunk = "eXIf" + exif_block(orientation);
  boost::crc_32_type checksum;
  checksum.process_bytes(chunk.data(), chunk.size());
  return png.insert(after_header, big_endian(static_cast<std::uint32_t>(chunk.size() - 4)) + chunk +
                                      big_endian(checksum.checksum()));
}

// Uncompressed 8-bit RGB, its directory before its pixels.
std::string tiff_with_orientation(const cv::Mat& image, unsigned orientation) {
  constexpr unsigned entries = 9;
  constexpr unsigned bits_at = 8 + 2 + entries * 12 + 4;
  constexpr unsigned pixels_at = bits_at + 6;
  const auto width = static_cast<unsigned>(image.cols);
  const auto height = static_cast<unsigned>(image.rows);
  std::string tiff = std::string("II*\0", 4) + little_endian(8, 4) + little_endian(entries, 2);
  tiff += tiff_entry(256, 4, width) + tiff_entry(257, 4, height);
  tiff += little_endian(258, 2) + little_endian(3, 2) + little_endian(3, 4) + little_endian(bits_at, 4);
  tiff += tiff_entry(259, 3, 1) + tiff_entry(262, 3, 2) + tiff_entry(273, 4, pixels_at);
  tiff += tiff_entry(274, 3, orientation) + tiff_entry(277, 3, 3) + tiff_entry(279, 4, width * height * 3);
  tiff += little_endian(0, 4) + little_endian(8, 2) + little_endian(8, 2) + little_endian(8, 2);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const auto bgr = image.at<cv::Vec3b>(y, x);
      tiff += {static_cast<char>(bgr[2]), static_cast<char>(bgr[1]), static_cast<char>(bgr[0])};
    }
  }
  return tiff;
}

class Orientation : public ::testing::TestWithParam<unsigned> {
 protected:
  testing::TemporaryFolder folder_;
  cv::Mat image_ = testing::patterned_image(40, 24, 3);
};

TEST_P(Orientation, OfJpegIsThatOfOpenCv) {
  const auto path = folder_.file("a.jpg", jpeg_with_orientation(image_, GetParam()));
  EXPECT_TRUE(alike(read_image(path), cv::imread(path.string())));
}

// Where the stored sample (x, y) belongs, by the definition of the tag (TIFF 6.0, page 36): 1 row 0 top,
// column 0 left; 2 top, right; 3 bottom, right; 4 bottom, left; 5 left, top; 6 right, top; 7 right, bottom; 8
// left, bottom.
cv::Point upright(cv::Point stored, cv::Size size, unsigned orientation) {
  const cv::Point from_far(size.width - 1 - stored.x, size.height - 1 - stored.y);
  switch (orientation) {
    case 2:
      return {from_far.x, stored.y};
    case 3:
      return from_far;
    case 4:
      return {stored.x, from_far.y};
    case 5:
      return {stored.y, stored.x};
    case 6:
      return {from_far.y, stored.x};
    case 7:
      return {from_far.y, from_far.x};
    case 8:
      return {stored.y, from_far.x};
    default:
      return stored;
  }
}

void expect_upright(const cv::Mat& seen, const cv::Mat& stored, unsigned orientation) {
  ASSERT_EQ(seen.size(), orientation >= 5 ? cv::Size(stored.rows, stored.cols) : stored.size());
  for (int y = 0; y < stored.rows; ++y) {
    for (int x = 0; x < stored.cols; ++x) {
      ASSERT_EQ(seen.at<cv::Vec3b>(upright({x, y}, stored.size(), orientation)), stored.at<cv::Vec3b>(y, x));
    }
  }
}

TEST_P(Orientation, OfTiffIsAsTheFormatDefinesIt) {
  const auto path = folder_.file("a.tif", tiff_with_orientation(image_, GetParam()));
  expect_upright(read_image(path), image_, GetParam());
}

TEST_P(Orientation, OfPngIsAsTheFormatDefinesIt) {
  const auto path = folder_.file("a.png", png_with_orientation(image_, GetParam()));
  expect_upright(read_image(path), image_, GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, Orientation, ::testing::Range(1U, 9U));

TEST(OrientationTag, OutOfRangeIsIgnored) {
  const testing::TemporaryFolder folder;
  const cv::Mat image = testing::patterned_image(40, 24, 3);
  const cv::Mat plain = read_image(folder.file("a.jpg", jpeg_with_orientation(image, 1)));
  EXPECT_TRUE(alike(read_image(folder.file("b.jpg", jpeg_with_orientation(image, 0))), plain));
  EXPECT_TRUE(alike(read_image(folder.file("c.jpg", jpeg_with_orientation(image, 9))), plain));
}

}  // namespace
}  // namespace sailmap
