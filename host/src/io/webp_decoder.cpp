#include <webp/decode.h>

#include "image_decoders.hpp"
#include "sailmap/error.hpp"

namespace sailmap::io {

namespace {

WebPBitstreamFeatures read_features(Bytes file) {
  WebPBitstreamFeatures features{};
  const VP8StatusCode status = WebPGetFeatures(file.data(), file.size(), &features);
  if (status == VP8_STATUS_NOT_ENOUGH_DATA) throw Error("truncated WebP");
  if (status != VP8_STATUS_OK) throw Error("damaged WebP");
  if (features.has_animation != 0) throw Error("animated WebP; give single images");
  check_size(features.width, features.height);
  return features;
}

// The size of the file as its RIFF header has it.
std::uint64_t declared_size(Bytes file) {
  constexpr std::size_t at = 4;
  std::uint64_t size = 0;
  for (std::size_t i = 0; i < 4; ++i) size |= std::uint64_t{file[at + i]} << (8 * i);
  return size + 8;
}

}  // namespace

cv::Mat decode_webp(Bytes file) {
  const WebPBitstreamFeatures features = read_features(file);
  if (declared_size(file) > file.size()) throw Error("truncated WebP");
  cv::Mat image(features.height, features.width, CV_8UC3);
  const auto stride = static_cast<int>(image.step[0]);
  const auto size = static_cast<std::size_t>(stride) * static_cast<std::size_t>(image.rows);
  if (WebPDecodeBGRInto(file.data(), file.size(), image.data, size, stride) == nullptr) {
    throw Error("damaged WebP");
  }
  return image;
}

}  // namespace sailmap::io
