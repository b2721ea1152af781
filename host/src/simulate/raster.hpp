// A small software renderer: flat textured surfaces seen by a pinhole camera, hidden parts removed by depth.
#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/matx.hpp>
#include <vector>

#include "texture.hpp"

namespace sailmap::simulate {

// A convex flat polygon with a picture on it. World axes: x, y on the ground, z up; metres.
struct Surface {
  static constexpr int max_corners = 5;
  std::array<cv::Vec3d, max_corners> corners;
  int corner_count = 0;
  // The picture's lower left corner and its two edges in the world: rightwards and up.
  cv::Vec3d origin, right, up;
  TexturePtr texture;
  cv::Vec3f tint = {1, 1, 1};  // factors of B, G, R
  float opacity = 1;           // of blended surfaces
};

// The parallelogram with a corner `origin` and edges `right` and `up`, covered by the whole picture.
Surface make_panel(const cv::Vec3d& origin, const cv::Vec3d& right, const cv::Vec3d& up, TexturePtr texture);

// Where the camera is and where it looks. Camera axes: x right, y down, z forward.
struct View {
  cv::Vec3d position;
  cv::Matx33d world_to_camera;
  double focal = 0;  // pixels
  double centre_x = 0;
  double centre_y = 0;

  // Level at `heading` (radians from x), then pitched up and rolled clockwise (radians).
  static cv::Matx33d rotation(double heading, double pitch, double roll);
};

// Things far away fade into the colour of the air.
struct Haze {
  cv::Vec3f colour;   // B, G, R, 0..255
  float range = 200;  // metres after which 1/e of a thing's own colour is left
};

class Raster {
 public:
  Raster(int width, int height, const View& view, const Haze& haze);

  // Paints opaque surfaces, the nearest first; texels less than half opaque are left out.
  void paint_solid(std::vector<Surface> surfaces);
  // Paints over what is there, the farthest first, by the picture's alpha.
  void paint_blended(std::vector<Surface> surfaces);

  [[nodiscard]] cv::Mat3b& colour() { return colour_; }
  // Distance along the optical axis in metres, infinite where nothing was painted.
  [[nodiscard]] const cv::Mat1f& depth() const { return depth_; }
  [[nodiscard]] const View& view() const { return view_; }
  [[nodiscard]] const Haze& haze() const { return haze_; }

 private:
  template <bool blended>
  void paint(const Surface& surface);
  // Columns each row of the projected polygon covers; false when it is outside the picture.
  bool find_spans(const Surface& surface);
  [[nodiscard]] double distance(const Surface& surface) const;

  View view_;
  Haze haze_;
  cv::Mat3b colour_;
  cv::Mat1f depth_;
  int first_row_ = 0;
  int last_row_ = 0;
  std::vector<double> left_, right_;  // by row
};

}  // namespace sailmap::simulate
