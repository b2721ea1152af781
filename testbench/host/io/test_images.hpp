// Images with some structure, for tests of reading and decoding.
#pragma once

#include <opencv2/core.hpp>

namespace sailmap::testing {

// Every pixel different from its neighbours, every channel different; 8-bit, 1, 3 or 4 channels.
inline cv::Mat patterned_image(int width, int height, int channels) {
  cv::Mat image(height, width, CV_8UC(channels));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < channels; ++c) {
        image.ptr(y)[x * channels + c] = static_cast<unsigned char>((7 * x + 13 * y + 71 * c + x * y) % 256);
      }
    }
  }
  return image;
}

// Same size and type, and no sample further apart than `tolerance`.
inline bool alike(const cv::Mat& a, const cv::Mat& b, double tolerance = 0) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) <= tolerance;
}

}  // namespace sailmap::testing
