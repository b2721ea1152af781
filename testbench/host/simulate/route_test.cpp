#include "simulate/route.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace sailmap::simulate {
namespace {

std::vector<cv::Vec2d> walk(const Route& route, int steps) {
  std::vector<cv::Vec2d> points;
  for (int i = 0; i < steps; ++i) points.push_back(route.at(route.length() * i / steps).position);
  return points;
}

TEST(Route, HasTheLengthAskedForAndCloses) {
  for (const double length : {100.0, 450.0, 7500.0}) {
    const Route route(3, length, 10);
    const int steps = static_cast<int>(length * 4);
    const std::vector<cv::Vec2d> points = walk(route, steps);
    double travelled = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      travelled += cv::norm(points[(i + 1) % points.size()] - points[i]);
    EXPECT_NEAR(travelled, length, 0.002 * length);
    EXPECT_LT(cv::norm(route.at(length).position - route.at(0).position), 1e-6);
    EXPECT_LT(cv::norm(route.at(-1).position - route.at(length - 1).position), 1e-6);
  }
}

// The radius of the circle through three points of the walk, from the points alone.
TEST(Route, BendsNoMoreSharplyThanAllowed) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const Route route(seed, 400, 12);
    const std::vector<cv::Vec2d> points = walk(route, 200);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const cv::Vec2d a = points[i];
      const cv::Vec2d b = points[(i + 1) % points.size()];
      const cv::Vec2d c = points[(i + 2) % points.size()];
      const double area = std::abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
      const double radius = cv::norm(b - a) * cv::norm(c - b) * cv::norm(a - c) / (4 * std::max(area, 1e-12));
      EXPECT_GT(radius, 11) << "seed " << seed << " at " << 2 * i << " m";
    }
  }
}

TEST(Route, HeadingPointsAlongTheCurve) {
  const Route route(5, 900, 12);
  for (int s = 0; s < 900; s += 13) {
    const cv::Vec2d step = route.at(s + 0.5).position - route.at(s - 0.5).position;
    const double difference =
        std::remainder(std::atan2(step[1], step[0]) - route.at(s).heading, 2 * std::numbers::pi);
    EXPECT_LT(std::abs(difference), 0.03);
  }
}

TEST(Route, KeepsAwayFromItself) {
  const Route route(9, 3000, 12);
  const std::vector<cv::Vec2d> points = walk(route, 1500);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 30; j < points.size() && i + points.size() - j > 30; ++j)
      ASSERT_GT(cv::norm(points[i] - points[j]), 16) << i << ' ' << j;
}

}  // namespace
}  // namespace sailmap::simulate
