#include "car.hpp"

#include <algorithm>
#include <cstddef>
#include <opencv2/core.hpp>

#include "canvas.hpp"
#include "random.hpp"

namespace sailmap::simulate {
namespace {

enum class Part : std::uint8_t { rear, rear_window, roof, windscreen, bonnet, front };

struct Vertex {
  double x, z;
};

// From the lower rear corner over the roof to the lower front corner, one part between each two vertices.
struct Profile {
  std::vector<Vertex> vertices;
  std::vector<Part> parts;
  double width;
};

Profile profile_of(int kind) {
  const std::vector<Part> parts = {Part::rear,       Part::rear_window, Part::roof,
                                   Part::windscreen, Part::bonnet,      Part::front};
  if (kind == 0)  // hatchback
    return {{{0, 0.28}, {0.02, 0.9}, {0.4, 1.42}, {2.2, 1.46}, {3.0, 0.98}, {3.9, 0.78}, {3.95, 0.28}},
            parts,
            1.7};
  if (kind == 1)  // saloon: the boot is a second bonnet
    return {
        {{0, 0.3}, {0.03, 0.9}, {0.75, 0.97}, {1.3, 1.4}, {2.5, 1.43}, {3.3, 0.97}, {4.45, 0.8}, {4.5, 0.3}},
        {Part::rear, Part::bonnet, Part::rear_window, Part::roof, Part::windscreen, Part::bonnet,
         Part::front},
        1.78};
  return {{{0, 0.35}, {0.02, 1.15}, {0.08, 2.15}, {3.7, 2.2}, {4.4, 1.3}, {4.95, 1.05}, {5, 0.35}},
          parts,
          1.9};  // van
}

cv::Mat4b draw_part(Part part, double width, double height, const Colour& paint, Random& random) {
  Canvas canvas(width, height, 40, paint);
  const Colour glass = rgb(46, 58, 70);
  switch (part) {
    case Part::rear_window:
    case Part::windscreen:
      canvas.box(0.1, 0.06, width - 0.1, height - 0.06, glass);
      canvas.shade(0.1, 0.06, width - 0.1, height - 0.06, 0.9, 1.9);
      break;
    case Part::rear:
      canvas.box(0, 0, width, 0.14, rgb(36, 36, 38));
      for (const double x : {0.05, width - 0.35})
        canvas.box(x, height - 0.34, x + 0.3, height - 0.12, rgb(190, 20, 24));
      canvas.box(width / 2 - 0.27, 0.2, width / 2 + 0.27, 0.33,
                 random.chance(0.5) ? rgb(240, 240, 236) : rgb(240, 206, 60));
      break;
    case Part::front:
      canvas.box(0, 0, width, 0.12, rgb(36, 36, 38));
      canvas.box(0.35, 0.16, width - 0.35, height - 0.12, rgb(30, 32, 34));
      for (const double x : {0.05, width - 0.37})
        canvas.box(x, height - 0.24, x + 0.32, height - 0.06, rgb(246, 246, 230));
      canvas.box(width / 2 - 0.27, 0.14, width / 2 + 0.27, 0.26, rgb(240, 240, 236));
      break;
    default:
      break;
  }
  return canvas.picture();
}

cv::Mat4b draw_side(const Profile& profile, int kind, double height, const Colour& paint) {
  const double length = profile.vertices.back().x;
  Canvas canvas(length, height, 48, clear());
  std::vector<cv::Point2d> outline;
  for (const Vertex& v : profile.vertices) outline.emplace_back(v.x, v.z);
  canvas.polygon(outline, paint);
  const Colour glass = rgb(46, 58, 70);
  if (kind == 2) {
    canvas.polygon({{3.0, 1.35}, {4.15, 1.35}, {3.65, 2.0}, {3.0, 2.0}}, glass);
    canvas.box(0.4, 1.2, 2.7, 1.7, scaled(paint, 0.75));
    canvas.ellipse(1.55, 1.45, 0.2, 0.2, rgb(246, 246, 246));
  } else {
    const double rear = kind == 0 ? 0.28 : 0.95;
    const double front = kind == 0 ? 2.75 : 3.05;
    const double top = height - 0.14;
    canvas.polygon({{rear, 0.95}, {front, 0.95}, {front - 0.7, top}, {rear + 0.3, top}}, glass);
    canvas.box((rear + front) / 2 - 0.1, 0.9, (rear + front) / 2, top, paint);
    for (const double x : {(rear + front) / 2 - 0.05, front})
      canvas.box(x, 0.35, x + 0.03, 0.93, scaled(paint, 0.6));
  }
  canvas.shade(0, 0.25, length, 0.75, 0.6, 1);
  for (const double x : {0.8, length - 0.85}) {
    canvas.ellipse(x, 0.31, 0.38, 0.38, rgb(20, 20, 22));
    canvas.ellipse(x, 0.31, 0.31, 0.31, rgb(34, 34, 36));
    canvas.ellipse(x, 0.31, 0.18, 0.18, rgb(168, 170, 174));
  }
  return canvas.picture();
}

Colour pick_paint(Random& random) {
  const double draw = random.uniform();
  if (draw < 0.2) return rgb(232, 232, 230);
  if (draw < 0.35) return rgb(44, 46, 50);
  if (draw < 0.5) return rgb(150, 154, 160);
  const double hue = random.uniform();
  return from_hsv(hue, random.uniform(0.6, 0.95), random.uniform(0.4, 0.85));
}

}  // namespace

CarModel::CarModel(int kind, std::uint64_t seed) : length_(0), width_(0), height_(0) {
  Random random(seed);
  const Profile profile = profile_of(kind);
  const Colour paint = pick_paint(random);
  length_ = profile.vertices.back().x;
  width_ = profile.width;
  for (const Vertex& v : profile.vertices) height_ = std::max(height_, v.z);
  for (std::size_t i = 0; i < profile.parts.size(); ++i) {
    const cv::Vec2d from(profile.vertices[i].x, profile.vertices[i].z);
    const cv::Vec2d to(profile.vertices[i + 1].x, profile.vertices[i + 1].z);
    cv::Mat4b picture = draw_part(profile.parts[i], width_, cv::norm(to - from), paint, random);
    // The front is drawn upright but its panel runs downwards.
    if (profile.parts[i] == Part::front) cv::flip(picture, picture, 0);
    panels_.push_back({from, to, make_texture(picture)});
  }
  side_ = make_texture(draw_side(profile, kind, height_, paint));
}

void CarModel::place(const cv::Vec3d& middle, const cv::Vec2d& forward, const Light& light,
                     std::vector<Surface>& surfaces) const {
  const cv::Vec3d ahead(forward[0], forward[1], 0);
  const cv::Vec3d left(-forward[1], forward[0], 0);
  const cv::Vec3d up(0, 0, 1);
  const cv::Vec3d corner = middle - 0.5 * length_ * ahead - 0.5 * width_ * left;  // rear right
  const auto add = [&](const cv::Vec3d& origin, const cv::Vec3d& right, const cv::Vec3d& rise,
                       const TexturePtr& texture, const cv::Vec3d& normal) {
    Surface s = make_panel(origin, right, rise, texture);
    const auto cosine = static_cast<float>(std::max(0.0, normal.dot(light.to_sun) / cv::norm(normal)));
    s.tint = light.ambient + light.sun * cosine;
    surfaces.push_back(s);
  };
  for (const Panel& panel : panels_) {
    const cv::Vec2d run = panel.to - panel.from;
    // Seen from behind, the picture's left is the car's left.
    const cv::Vec3d origin = corner + panel.from[0] * ahead + panel.from[1] * up + width_ * left;
    add(origin, -width_ * left, run[0] * ahead + run[1] * up, panel.texture, run[0] * up - run[1] * ahead);
  }
  add(corner, length_ * ahead, height_ * up, side_, -left);
  add(corner + width_ * left, length_ * ahead, height_ * up, side_, left);
}

std::vector<CarModel> make_cars(int colours) {
  std::vector<CarModel> cars;
  for (int i = 0; i < colours; ++i)
    for (int kind = 0; kind < CarModel::kinds; ++kind)
      cars.emplace_back(kind, hash(0, Subject::sprites, 8, kind, i));
  return cars;
}

}  // namespace sailmap::simulate
