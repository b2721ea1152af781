// The pictures that buildings share.
#pragma once

#include <vector>

#include "canvas.hpp"
#include "texture.hpp"

namespace sailmap::simulate {

std::vector<TexturePtr> make_side_walls(double density, const cv::Mat1b& noise_plate);
std::vector<TexturePtr> make_roofs(double density, const cv::Mat1b& noise_plate);  // 8 m x 4 m
std::vector<TexturePtr> make_hanging_signs();                                      // 0.9 m x 0.9 m
std::vector<TexturePtr> make_fences(const cv::Mat1b& noise_plate);                 // by Fence; 8 m x 1.8 m

}  // namespace sailmap::simulate
