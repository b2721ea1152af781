// Drawing in metres: x from the left, y from the bottom, as on an architect's elevation.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>
#include <string>
#include <vector>

namespace sailmap::simulate {

using Colour = cv::Scalar;  // B, G, R, alpha; 0..255, premultiplied

inline Colour rgb(double r, double g, double b) { return {b, g, r, 255}; }
inline Colour clear() { return {0, 0, 0, 0}; }
// Lighter (factor > 1) or darker.
Colour scaled(const Colour& colour, double factor);
Colour blend(const Colour& a, const Colour& b, double part_of_b);
// From hue 0..1 (red, yellow, green, blue, red), saturation and value 0..1.
Colour from_hsv(double hue, double saturation, double value);

// first, first + step, ... below `end`.
std::vector<double> steps(double first, double end, double step);

class Canvas {
 public:
  // Size in metres, `density` in pixels a metre.
  Canvas(double width, double height, double density, const Colour& fill);

  void box(double x0, double y0, double x1, double y1, const Colour& colour);
  void polygon(const std::vector<cv::Point2d>& corners, const Colour& colour);
  void ellipse(double x, double y, double radius_x, double radius_y, const Colour& colour);
  void stroke(double x0, double y0, double x1, double y1, double thickness, const Colour& colour);
  // Capital letters as large as fit into the box.
  void text(const std::string& words, double x0, double y0, double x1, double y1, const Colour& colour);
  // Multiplies the colours in the box by a factor that goes from `bottom` to `top`.
  void shade(double x0, double y0, double x1, double y1, double bottom, double top);
  // Multiplies every colour by 1 + grain * fine noise + blotch * coarse noise (noise in -1..1), read from
  // `plate` at an offset; coarse noise is the plate magnified eightfold.
  void weather(const cv::Mat1b& plate, cv::Point offset, double grain, double blotch);

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }
  [[nodiscard]] double density() const { return density_; }
  [[nodiscard]] const cv::Mat4b& picture() const { return picture_; }
  [[nodiscard]] cv::Mat4b& picture() { return picture_; }

 private:
  [[nodiscard]] cv::Point fixed(double x, double y) const;  // in 1/16 pixel
  [[nodiscard]] cv::Rect pixels(double x0, double y0, double x1, double y1) const;

  double width_;
  double height_;
  double density_;
  cv::Mat4b picture_;
};

// A 256 x 256 plate of noise about 128 that tiles; octaves from 2 to 64 pixels.
cv::Mat1b make_noise_plate(std::uint64_t seed);

}  // namespace sailmap::simulate
