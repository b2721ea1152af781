#include "texture.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace sailmap::simulate {

TexturePtr make_texture(const cv::Mat4b& picture) {
  auto texture = std::make_shared<Texture>();
  texture->levels.push_back(picture.clone());
  while (texture->levels.back().cols > 1 && texture->levels.back().rows > 1) {
    const cv::Mat4b& last = texture->levels.back();
    cv::Mat4b half;
    cv::resize(last, half, {last.cols / 2, last.rows / 2}, 0, 0, cv::INTER_AREA);
    texture->levels.push_back(half);
  }
  return texture;
}

}  // namespace sailmap::simulate
