// A picture to put on surfaces, with its smaller versions for surfaces far away.
#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace sailmap::simulate {

// levels[0] is the picture, each next one half its size; 8-bit BGRA, colours multiplied by alpha. The first
// row is the top of the picture.
struct Texture {
  std::vector<cv::Mat4b> levels;
};

using TexturePtr = std::shared_ptr<const Texture>;

// Of a non-empty BGRA picture with premultiplied alpha.
TexturePtr make_texture(const cv::Mat4b& picture);

}  // namespace sailmap::simulate
