#include "canvas.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "random.hpp"

namespace sailmap::simulate {
namespace {

constexpr int shift = 4;  // fractional bits of OpenCV's drawing coordinates

uchar to_byte(double value) { return cv::saturate_cast<uchar>(value); }

}  // namespace

Colour scaled(const Colour& colour, double factor) {
  Colour out = colour;
  for (int c = 0; c < 3; ++c) out[c] = std::min(255.0, out[c] * factor);
  return out;
}

Colour blend(const Colour& a, const Colour& b, double part_of_b) {
  return a * (1 - part_of_b) + b * part_of_b;
}

Colour from_hsv(double hue, double saturation, double value) {
  const auto channel = [&](double offset) {
    const double place = 6 * (hue + offset - std::floor(hue + offset));
    return 255 * value * (1 - saturation * std::clamp(std::abs(place - 3) - 1, 0.0, 1.0));
  };
  return rgb(channel(0.5), channel(1.0 / 6), channel(5.0 / 6));
}

std::vector<double> steps(double first, double end, double step) {
  std::vector<double> values;
  for (int i = 0; first + i * step < end; ++i) values.push_back(first + i * step);
  return values;
}

Canvas::Canvas(double width, double height, double density, const Colour& fill)
    : width_(width),
      height_(height),
      density_(density),
      picture_(std::max(2, static_cast<int>(std::lround(height * density))),
               std::max(2, static_cast<int>(std::lround(width * density))),
               cv::Vec4b(to_byte(fill[0]), to_byte(fill[1]), to_byte(fill[2]), to_byte(fill[3]))) {}

cv::Point Canvas::fixed(double x, double y) const {
  const double scale = density_ * (1 << shift);
  const double half = 0.5 * (1 << shift);  // pixel centres are whole numbers to OpenCV
  return {static_cast<int>(std::lround(x * scale - half)),
          static_cast<int>(std::lround((height_ - y) * scale - half))};
}

cv::Rect Canvas::pixels(double x0, double y0, double x1, double y1) const {
  const auto round = [&](double metres) { return static_cast<int>(std::lround(metres * density_)); };
  const cv::Point first(round(std::min(x0, x1)), round(height_ - std::max(y0, y1)));
  const cv::Point last(round(std::max(x0, x1)), round(height_ - std::min(y0, y1)));
  return cv::Rect(first, last) & cv::Rect({0, 0}, picture_.size());
}

void Canvas::box(double x0, double y0, double x1, double y1, const Colour& colour) {
  const cv::Rect area = pixels(x0, y0, x1, y1);
  if (!area.empty()) picture_(area).setTo(colour);
}

void Canvas::polygon(const std::vector<cv::Point2d>& corners, const Colour& colour) {
  std::vector<cv::Point> points;
  points.reserve(corners.size());
  for (const cv::Point2d& corner : corners) points.push_back(fixed(corner.x, corner.y));
  cv::fillPoly(picture_, points, colour, cv::LINE_AA, shift);
}

void Canvas::ellipse(double x, double y, double radius_x, double radius_y, const Colour& colour) {
  const double scale = density_ * (1 << shift);
  const cv::Size axes(static_cast<int>(std::lround(radius_x * scale)),
                      static_cast<int>(std::lround(radius_y * scale)));
  cv::ellipse(picture_, fixed(x, y), axes, 0, 0, 360, colour, cv::FILLED, cv::LINE_AA, shift);
}

void Canvas::stroke(double x0, double y0, double x1, double y1, double thickness, const Colour& colour) {
  const double length = std::max(1e-9, std::hypot(x1 - x0, y1 - y0));
  const double dx = -(y1 - y0) / length * thickness / 2;
  const double dy = (x1 - x0) / length * thickness / 2;
  polygon({{x0 + dx, y0 + dy}, {x1 + dx, y1 + dy}, {x1 - dx, y1 - dy}, {x0 - dx, y0 - dy}}, colour);
}

void Canvas::text(const std::string& words, double x0, double y0, double x1, double y1,
                  const Colour& colour) {
  const int font = cv::FONT_HERSHEY_DUPLEX;
  const cv::Size plain = cv::getTextSize(words, font, 1, 1, nullptr);
  const double scale = std::min((x1 - x0) * density_ / plain.width, (y1 - y0) * density_ / plain.height);
  const int thickness = std::max(1, static_cast<int>(std::lround(2.4 * scale)));
  const double left = (x0 + x1) / 2 * density_ - plain.width * scale / 2;
  const double base = (height_ - (y0 + y1) / 2) * density_ + plain.height * scale / 2;
  cv::putText(picture_, words, {static_cast<int>(std::lround(left)), static_cast<int>(std::lround(base))},
              font, scale, colour, thickness, cv::LINE_AA);
}

void Canvas::shade(double x0, double y0, double x1, double y1, double bottom, double top) {
  const cv::Rect area = pixels(x0, y0, x1, y1);
  for (int y = area.y; y < area.y + area.height; ++y) {
    const double part = (y - area.y + 0.5) / area.height;
    const auto factor = static_cast<float>(top + (bottom - top) * part);
    for (int x = area.x; x < area.x + area.width; ++x) {
      cv::Vec4b& pixel = picture_(y, x);
      for (int c = 0; c < 3; ++c)
        pixel[c] = static_cast<uchar>(std::min(255.0F, static_cast<float>(pixel[c]) * factor));
    }
  }
}

void Canvas::weather(const cv::Mat1b& plate, cv::Point offset, double grain, double blotch) {
  const int side = plate.cols;
  const int fine_weight = static_cast<int>(grain * 256);
  const int coarse_weight = static_cast<int>(blotch * 256);
  for (int y = 0; y < picture_.rows; ++y) {
    const uchar* fine = plate[(y + offset.y) % side];
    const int coarse_y = y + 7 * offset.y;
    const uchar* above = plate[coarse_y / 8 % side];
    const uchar* below = plate[(coarse_y / 8 + 1) % side];
    const int below_part = coarse_y % 8;
    for (int x = 0; x < picture_.cols; ++x) {
      const int coarse_x = x + 7 * offset.x;
      const int left = coarse_x / 8 % side;
      const int right = (left + 1) % side;
      const int right_part = coarse_x % 8;
      const int coarse = (above[left] * (8 - right_part) + above[right] * right_part) * (8 - below_part) +
                         (below[left] * (8 - right_part) + below[right] * right_part) * below_part;
      const int factor =
          (1 << 15) + (fine[(x + offset.x) % side] - 128) * fine_weight + (coarse / 64 - 128) * coarse_weight;
      cv::Vec4b& pixel = picture_(y, x);
      for (int c = 0; c < 3; ++c)
        pixel[c] = static_cast<uchar>(std::clamp(pixel[c] * factor >> 15, 0, static_cast<int>(pixel[3])));
    }
  }
}

cv::Mat1b make_noise_plate(std::uint64_t seed) {
  constexpr int side = 256;
  cv::Mat1f sum(side, side, 0.0F);
  float weight = 1;
  for (int cell = 64; cell >= 2; cell /= 2, weight *= 0.75F) {
    const int cells = side / cell;
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const auto corner = [&](int cx, int cy) {
          return static_cast<float>(2 * unit(hash(seed, Subject::plate, cell, cx % cells, cy % cells)) - 1);
        };
        const float u = static_cast<float>(x % cell) / static_cast<float>(cell);
        const float v = static_cast<float>(y % cell) / static_cast<float>(cell);
        const float a = corner(x / cell, y / cell) * (1 - u) + corner(x / cell + 1, y / cell) * u;
        const float b = corner(x / cell, y / cell + 1) * (1 - u) + corner(x / cell + 1, y / cell + 1) * u;
        sum(y, x) += weight * (a * (1 - v) + b * v);
      }
    }
  }
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(sum, mean, deviation);
  cv::Mat1b plate;
  sum.convertTo(plate, CV_8U, 48 / deviation[0], 128 - mean[0] * 48 / deviation[0]);
  return plate;
}

}  // namespace sailmap::simulate
