// Fronts of buildings, drawn from a seed.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace sailmap::simulate {

enum class RoofShape : std::uint8_t { flat, pitched, gable, stepped };

struct FacadePlan {
  double width = 10;  // metres
  double eaves = 9;   // height of the wall, without the gable
  double rise = 0;    // height of the gable above the eaves; 0 for flat and pitched roofs
  RoofShape roof = RoofShape::flat;
  std::uint64_t style = 0;   // the architect's choices: same style, same kind of house
  std::uint64_t detail = 0;  // the tenants' choices: signs, curtains, colour of the door
};

// BGRA, width x (eaves + rise) metres at `density` pixels a metre; transparent outside a gable.
cv::Mat4b draw_facade(const FacadePlan& plan, double density, const cv::Mat1b& noise_plate);

// The main colour of the walls, for the sides of the building: B, G, R factors of a white wall.
cv::Vec3f wall_tint(std::uint64_t style);

// A building's side: a wall to be tinted, some with windows, an advertisement or a mural. 8 m wide, 12 m
// high.
cv::Mat4b draw_side_wall(std::uint64_t seed, double density, const cv::Mat1b& noise_plate);

}  // namespace sailmap::simulate
