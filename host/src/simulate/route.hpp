// The circuit: a smooth closed curve that does not meet itself, driven counter-clockwise.
#pragma once

#include <cstdint>
#include <opencv2/core/matx.hpp>
#include <vector>

namespace sailmap::simulate {

// A place on the curve, and the street's directions there.
struct RoutePoint {
  cv::Vec2d position;    // metres
  double heading = 0;    // radians from the x axis, not wrapped
  double curvature = 0;  // 1/metres, positive where the curve turns left

  // The point `lateral` metres to the left of the curve, `height` above the ground.
  [[nodiscard]] cv::Vec3d beside(double lateral, double height = 0) const;
  [[nodiscard]] cv::Vec2d forward() const;
};

class Route {
 public:
  // A curve of exactly `length` metres, nowhere bent more sharply than to `least_radius` metres, which must
  // be less than length / (2 pi): that of the circle.
  Route(std::uint64_t seed, double length, double least_radius);

  [[nodiscard]] double length() const { return length_; }
  // `distance` along the curve in metres; any value, the curve is closed.
  [[nodiscard]] RoutePoint at(double distance) const;

 private:
  double length_;
  double step_ = 0;                // metres between nodes
  std::vector<RoutePoint> nodes_;  // at equal distances
};

}  // namespace sailmap::simulate
