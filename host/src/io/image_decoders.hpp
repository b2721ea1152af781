// One decoder per image format. Each takes a whole file held in memory and returns an 8-bit BGR image, as it
// should be looked at (orientation tags are obeyed). Each throws Error with the fault alone ("truncated
// JPEG"): the caller knows the name of the file. None of them prints.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <span>

namespace sailmap::io {

using Bytes = std::span<const std::uint8_t>;

// No image of more pixels is decoded: a damaged header would have gigabytes allocated.
inline constexpr std::int64_t max_pixels = std::int64_t{1} << 28;

cv::Mat decode_jpeg(Bytes file);
cv::Mat decode_png(Bytes file);
cv::Mat decode_tiff(Bytes file);
cv::Mat decode_webp(Bytes file);
cv::Mat decode_bmp(Bytes file);
cv::Mat decode_pnm(Bytes file);

// Throws Error when a size read from a header is not 1..max_pixels pixels.
void check_size(std::int64_t width, std::int64_t height);

// The orientation (1..8, TIFF 6.0 tag 274) in a block of EXIF data that begins with "Exif\0\0"; 1 when it has
// none.
int exif_orientation(Bytes exif);

// Turns and mirrors an image that was stored in orientation 1..8 (anything else: 1) into upright position.
void make_upright(cv::Mat& image, int orientation);

}  // namespace sailmap::io
