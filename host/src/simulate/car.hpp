// Cars and vans: flat panels bent along a profile, with a cut-out side on either hand.
#pragma once

#include <opencv2/core/matx.hpp>
#include <vector>

#include "raster.hpp"
#include "texture.hpp"

namespace sailmap::simulate {

class CarModel {
 public:
  // Kind 0 .. kinds-1 in the colour of `seed`.
  static constexpr int kinds = 3;
  CarModel(int kind, std::uint64_t seed);

  // The car's middle on the ground, where its bonnet points (unit vector), and the light on faces that look
  // along `sun` (see Lighting): ambient + sun * cosine.
  struct Light {
    cv::Vec3d to_sun;
    cv::Vec3f ambient, sun;
  };
  void place(const cv::Vec3d& middle, const cv::Vec2d& forward, const Light& light,
             std::vector<Surface>& surfaces) const;

  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] double width() const { return width_; }

 private:
  struct Panel {
    cv::Vec2d from, to;  // along the car and up, metres
    TexturePtr texture;
  };
  std::vector<Panel> panels_;
  TexturePtr side_;
  double length_;
  double width_;
  double height_;
};

// All kinds in `colours` colours.
std::vector<CarModel> make_cars(int colours);

}  // namespace sailmap::simulate
