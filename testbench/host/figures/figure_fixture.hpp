// What the tests of the figures share: a folder of their own, pictures and how to look at pixels.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <opencv2/core.hpp>
#include <pugixml.hpp>
#include <random>
#include <string>

#include "sailmap/frontend.hpp"
#include "sailmap/image_source.hpp"
#include "sailmap/signature.hpp"

namespace sailmap::testing {

class FigureTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("sailmap-figures-" + std::to_string(::getpid()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::ptrdiff_t files() const {
    return std::distance(std::filesystem::directory_iterator(folder_), {});
  }
  [[nodiscard]] static std::string contents(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::filesystem::path folder_;
};

// Smooth coloured noise: no two places of it look alike.
inline cv::Mat picture(int width, int height, unsigned seed = 1) {
  cv::Mat image(height, width, CV_8UC3);
  std::mt19937 random(seed);
  cv::Vec3d value(128, 128, 128);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) value[c] += 0.1 * (static_cast<double>(random() % 256) - value[c]);
      image.at<cv::Vec3b>(y, x) = value;
    }
  }
  return image;
}

struct Described {
  cv::Mat image;
  Maps maps;
  Signature signature;
};

inline Described described(const cv::Mat& image) {
  Described d;
  d.image = image;
  make_frontend("reference")->compute(view_of(image), d.maps);
  d.signature = make_signature(d.maps, {});
  return d;
}

inline cv::Vec3b colour_at(const cv::Mat& image, int x, int y) { return image.at<cv::Vec3b>(y, x); }
inline cv::Vec3b bytes(const cv::Scalar& colour) {
  return {static_cast<std::uint8_t>(colour[0]), static_cast<std::uint8_t>(colour[1]),
          static_cast<std::uint8_t>(colour[2])};
}

// Pixels of exactly this colour.
inline int count_colour(const cv::Mat& image, const cv::Vec3b& colour) {
  int count = 0;
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) count += image.at<cv::Vec3b>(y, x) == colour ? 1 : 0;
  }
  return count;
}

// All words of an SVG, one text element a line.
inline std::string all_text(const pugi::xml_document& document) {
  std::string text;
  for (const auto& found : document.select_nodes("//text")) {
    for (const auto& part : found.node().select_nodes(".//text()")) text += part.node().value();
    text += '\n';
  }
  return text;
}

}  // namespace sailmap::testing
