#include "route.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "random.hpp"

namespace sailmap::simulate {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double node_spacing = 0.5;  // metres

struct Harmonic {
  int order;
  double amplitude;  // of the mean radius
  double phase;
};

// Broad bends that give the circuit its shape and, where there is room, bends every one to two hundred
// metres.
std::vector<Harmonic> draw_harmonics(std::uint64_t seed, double length) {
  Random random(hash(seed, Subject::route));
  std::vector<Harmonic> harmonics;
  for (int order = 2; order <= 4; ++order)
    harmonics.push_back({order, random.uniform(0.3, 0.6) / (order * order), random.uniform(0, turn)});
  for (int bend = 0; bend < 6; ++bend) {
    const int order = static_cast<int>(length / random.uniform(90, 260));
    const double amplitude = random.uniform(5, 14) / (length / turn);
    const double phase = random.uniform(0, turn);
    if (order > 4) harmonics.push_back({order, amplitude, phase});
  }
  return harmonics;
}

// The curve r(angle) about the origin: it cannot meet itself.
std::vector<cv::Vec2d> sample_curve(const std::vector<Harmonic>& harmonics, double strength, int samples) {
  std::vector<cv::Vec2d> curve;
  curve.reserve(static_cast<std::size_t>(samples));
  for (int i = 0; i < samples; ++i) {
    const double angle = turn * i / samples;
    double radius = 1;
    for (const Harmonic& h : harmonics)
      radius += strength * h.amplitude * std::cos(h.order * angle + h.phase);
    curve.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return curve;
}

// The closed polygon's corners replaced by `count` points at equal distances along it, scaled to `length`.
std::vector<cv::Vec2d> resample(const std::vector<cv::Vec2d>& curve, int count, double length) {
  const std::size_t size = curve.size();
  std::vector<double> travelled(size + 1, 0);
  for (std::size_t i = 0; i < size; ++i)
    travelled[i + 1] = travelled[i] + cv::norm(curve[(i + 1) % size] - curve[i]);
  const double scale = length / travelled[size];
  std::vector<cv::Vec2d> points;
  points.reserve(static_cast<std::size_t>(count));
  std::size_t edge = 0;
  for (int i = 0; i < count; ++i) {
    const double wanted = travelled[size] * i / count;
    while (travelled[edge + 1] < wanted) ++edge;
    const double part = (wanted - travelled[edge]) / (travelled[edge + 1] - travelled[edge]);
    points.push_back(scale * (curve[edge] + part * (curve[(edge + 1) % size] - curve[edge])));
  }
  return points;
}

double wrapped(double angle) { return std::remainder(angle, turn); }

// Headings from the neighbours on either side, without jumps; curvature from the headings.
std::vector<RoutePoint> make_nodes(const std::vector<cv::Vec2d>& points, double step) {
  const std::size_t size = points.size();
  std::vector<RoutePoint> nodes(size);
  for (std::size_t i = 0; i < size; ++i) {
    const cv::Vec2d along = points[(i + 1) % size] - points[(i + size - 1) % size];
    const double raw = std::atan2(along[1], along[0]);
    nodes[i].position = points[i];
    nodes[i].heading = i == 0 ? raw : nodes[i - 1].heading + wrapped(raw - nodes[i - 1].heading);
  }
  for (std::size_t i = 0; i < size; ++i) {
    const double change = nodes[(i + 1) % size].heading - nodes[(i + size - 1) % size].heading;
    nodes[i].curvature = wrapped(change) / (2 * step);
  }
  return nodes;
}

double sharpest(const std::vector<RoutePoint>& nodes) {
  double most = 0;
  for (const RoutePoint& node : nodes) most = std::max(most, std::abs(node.curvature));
  return most;
}

}  // namespace

cv::Vec2d RoutePoint::forward() const { return {std::cos(heading), std::sin(heading)}; }

cv::Vec3d RoutePoint::beside(double lateral, double height) const {
  return {position[0] - lateral * std::sin(heading), position[1] + lateral * std::cos(heading), height};
}

Route::Route(std::uint64_t seed, double length, double least_radius) : length_(length) {
  const std::vector<Harmonic> harmonics = draw_harmonics(seed, length);
  const int count = static_cast<int>(std::lround(length / node_spacing));
  step_ = length / count;
  // Straighten until every bend is wide enough; strength 0 would be the circle.
  double strength = 1;
  do {
    nodes_ = make_nodes(resample(sample_curve(harmonics, strength, 4 * count), count, length), step_);
    strength *= 0.85;
  } while (sharpest(nodes_) * least_radius > 1);
}

RoutePoint Route::at(double distance) const {
  const double place = (distance - std::floor(distance / length_) * length_) / step_;
  const std::size_t i = static_cast<std::size_t>(place) % nodes_.size();
  const double part = place - std::floor(place);
  const RoutePoint& a = nodes_[i];
  const RoutePoint& b = nodes_[(i + 1) % nodes_.size()];
  return {a.position + part * (b.position - a.position), a.heading + part * wrapped(b.heading - a.heading),
          a.curvature + part * (b.curvature - a.curvature)};
}

}  // namespace sailmap::simulate
