#include "buildings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <opencv2/imgproc.hpp>

#include "building_textures.hpp"
#include "random.hpp"

namespace sailmap::simulate {

// Corners on the ground: the front as seen from the street, and behind it.
struct Buildings::Footprint {
  cv::Vec3d left, right, left_back, right_back;
  cv::Vec3d to_street;  // unit vector

  [[nodiscard]] double width() const { return cv::norm(right - left); }
};

Buildings::Buildings(std::uint64_t seed, const StreetPlan& plan, double density, const cv::Mat1b& noise_plate,
                     std::vector<cv::Mat> photographs)
    : seed_(seed),
      plan_(plan),
      density_(density),
      noise_plate_(noise_plate),
      photographs_(std::move(photographs)),
      side_walls_(make_side_walls(0.8 * density, noise_plate)),
      roofs_(make_roofs(0.8 * density, noise_plate)),
      signs_(make_hanging_signs()),
      fences_(make_fences(noise_plate)),
      facades_(72) {}

void Buildings::place(double first, double last, const Moment& moment, const Sprites& sprites,
                      Scene& scene) const {
  const int count = lot_count(plan_);
  const double pitch = plan_.route->length() / count;
  const int from = static_cast<int>(std::floor(first / pitch));
  const int to = std::min(static_cast<int>(std::ceil(last / pitch)), from + count);
  for (const int side : {1, -1}) {
    for (int number = from; number < to; ++number) {
      const Lot lot = make_lot(seed_, plan_, side, number);
      const Footprint at = measure(lot);
      if (moment.behind(at.left) && moment.behind(at.right)) continue;
      if (lot.garden) {
        place_garden(lot, at, moment, sprites, scene);
      } else {
        place_front(lot, at, moment, scene);
        place_sides(lot, at, moment, scene);
        place_roof(lot, at, moment, scene);
        place_hanging_sign(lot, at, moment, scene);
      }
    }
  }
}

Buildings::Footprint Buildings::measure(const Lot& lot) const {
  const RoutePoint first = plan_.route->at(lot.first);
  const RoutePoint last = plan_.route->at(lot.last);
  const double room = std::min(room_behind(plan_, first.curvature, lot.side, 10),
                               room_behind(plan_, last.curvature, lot.side, 10));
  const double front = plan_.front + std::min(lot.setback, 0.3 * room);
  const double back = plan_.front + room;
  Footprint at;
  // From the street, the way ahead is on the right of what stands on the left, and the other way round.
  const RoutePoint& on_left = lot.side > 0 ? first : last;
  const RoutePoint& on_right = lot.side > 0 ? last : first;
  at.left = on_left.beside(lot.side * front);
  at.right = on_right.beside(lot.side * front);
  at.left_back = on_left.beside(lot.side * back);
  at.right_back = on_right.beside(lot.side * back);
  const cv::Vec3d across = at.right - at.left;
  at.to_street = cv::Vec3d(across[1], -across[0], 0) / cv::norm(across);
  return at;
}

cv::Mat4b Buildings::photograph(const Lot& lot, double width, double height) const {
  Random random(hash(lot.detail, Subject::photo));
  const cv::Mat& photo =
      photographs_[static_cast<std::size_t>(random.index(static_cast<int>(photographs_.size())))];
  // The largest part of the photograph with the shape of the front, from anywhere in it.
  const double scale = std::min(photo.cols / width, photo.rows / height);
  const int columns = std::clamp(static_cast<int>(width * scale), 1, photo.cols);
  const int rows = std::clamp(static_cast<int>(height * scale), 1, photo.rows);
  const int x = random.index(photo.cols - columns + 1);
  const int y = random.index(photo.rows - rows + 1);
  const cv::Size size(std::max(2, static_cast<int>(width * density_)),
                      std::max(2, static_cast<int>(height * density_)));
  cv::Mat part;
  cv::resize(photo({x, y, columns, rows}), part, size, 0, 0,
             scale > density_ ? cv::INTER_AREA : cv::INTER_LINEAR);
  cv::Mat4b picture;
  cv::cvtColor(part, picture, cv::COLOR_BGR2BGRA);
  return picture;
}

TexturePtr Buildings::facade(const Lot& lot, double width, double rise) const {
  const std::uint64_t key = hash(0, Subject::lot, lot.side, lot.index);
  return facades_.get(key, [&] {
    if (!photographs_.empty()) return make_texture(photograph(lot, width, lot.eaves + rise));
    return make_texture(
        draw_facade({width, lot.eaves, rise, lot.roof, lot.style, lot.detail}, density_, noise_plate_));
  });
}

void Buildings::place_front(const Lot& lot, const Footprint& at, const Moment& moment, Scene& scene) const {
  const bool gabled = lot.roof == RoofShape::gable || lot.roof == RoofShape::stepped;
  const double rise = gabled && photographs_.empty() ? lot.rise : 0;
  Surface s =
      make_panel(at.left, at.right - at.left, {0, 0, lot.eaves + rise}, facade(lot, at.width(), rise));
  s.tint = moment.lighting.on(at.to_street);
  scene.solid.push_back(s);
}

void Buildings::place_sides(const Lot& lot, const Footprint& at, const Moment& moment, Scene& scene) const {
  const cv::Vec3d up(0, 0, 1);
  const double ridge = lot.roof == RoofShape::pitched ? lot.eaves + lot.rise : lot.eaves;
  const TexturePtr& texture = side_walls_[hash(lot.style, Subject::gap) % side_walls_.size()];
  const auto add = [&](const cv::Vec3d& front, const cv::Vec3d& back, bool front_on_left) {
    const cv::Vec3d inwards = (back - front) / cv::norm(back - front);
    const cv::Vec3d outwards =
        front_on_left ? cv::Vec3d(inwards[1], -inwards[0], 0) : cv::Vec3d(-inwards[1], inwards[0], 0);
    Surface s;
    s.corners = {front, back, back + lot.eaves * up, 0.5 * (front + back) + ridge * up,
                 front + lot.eaves * up};
    s.corner_count = 5;
    s.right = (front_on_left ? 8 : -8) * inwards;
    s.origin = front_on_left ? front : front + 8 * inwards;
    s.up = 12 * up;
    s.texture = texture;
    s.tint = wall_tint(lot.style).mul(moment.lighting.on(outwards));
    scene.solid.push_back(s);
  };
  add(at.left, at.left_back, false);
  add(at.right, at.right_back, true);
}

void Buildings::place_roof(const Lot& lot, const Footprint& at, const Moment& moment, Scene& scene) const {
  if (lot.roof == RoofShape::flat) return;
  const cv::Vec3d up(0, 0, 1);
  const TexturePtr& texture = roofs_[hash(lot.style, Subject::tree) % roofs_.size()];
  const auto add = [&](const cv::Vec3d& eaves_left, const cv::Vec3d& eaves_right,
                       const cv::Vec3d& ridge_right, const cv::Vec3d& ridge_left) {
    Surface s = make_panel(eaves_left, eaves_right - eaves_left, ridge_left - eaves_left, texture);
    s.corners[2] = ridge_right;
    const cv::Vec3d normal = s.right.cross(s.up);
    s.tint = moment.lighting.on(normal / cv::norm(normal));
    scene.solid.push_back(s);
  };
  const cv::Vec3d eaves = lot.eaves * up;
  const cv::Vec3d ridge = (lot.eaves + lot.rise) * up;
  if (lot.roof == RoofShape::pitched) {
    const cv::Vec3d left = 0.5 * (at.left + at.left_back) + ridge;
    const cv::Vec3d right = 0.5 * (at.right + at.right_back) + ridge;
    const cv::Vec3d overhang = 0.3 * at.to_street - 0.2 * up;
    add(at.left + eaves + overhang, at.right + eaves + overhang, right, left);
    return;
  }
  const cv::Vec3d front = 0.5 * (at.left + at.right) + ridge - 0.25 * up;
  const cv::Vec3d back = 0.5 * (at.left_back + at.right_back) + ridge - 0.25 * up;
  add(at.left_back + eaves, at.left + eaves, front, back);
  add(at.right + eaves, at.right_back + eaves, back, front);
}

void Buildings::place_hanging_sign(const Lot& lot, const Footprint& at, const Moment& moment,
                                   Scene& scene) const {
  Random random(hash(lot.detail, Subject::furniture));
  if (!random.chance(0.45)) return;
  const double part = random.uniform(0.15, 0.85);
  const cv::Vec3d foot = at.left + part * (at.right - at.left) + 0.1 * at.to_street;
  const cv::Vec3d base = foot + cv::Vec3d(0, 0, random.uniform(2.7, 3.4));
  const cv::Vec3d out = 0.9 * at.to_street;
  // Readable for those who drive on: their left is the wall on the left side, the sign's tip on the right
  // side.
  const cv::Vec3d start = lot.side > 0 ? base : base + out;
  Surface s = make_panel(start, lot.side > 0 ? out : -out, {0, 0, 0.9},
                         signs_[static_cast<std::size_t>(random.index(static_cast<int>(signs_.size())))]);
  s.tint = moment.lighting.ambient * 1.2F;
  scene.solid.push_back(s);
}

void Buildings::place_garden(const Lot& lot, const Footprint& at, const Moment& moment,
                             const Sprites& sprites, Scene& scene) const {
  const cv::Vec3d along = (at.right - at.left) / at.width();
  Surface s =
      make_panel(at.left, at.right - at.left, {0, 0, 1.8}, fences_[static_cast<std::size_t>(lot.fence)]);
  s.right = 8 * along;
  s.tint = moment.lighting.on(at.to_street);
  for (const double start : steps(0, at.width(), 8)) {  // the picture again and again
    const double end = std::min(start + 8, at.width());
    s.origin = at.left + start * along;
    s.corners = {s.origin, at.left + end * along, at.left + end * along + s.up, s.origin + s.up, cv::Vec3d()};
    scene.solid.push_back(s);
  }
  Random random(hash(lot.detail, Subject::tree));
  const int trees = 1 + random.index(4);
  for (int i = 0; i < trees; ++i) {
    const double across = random.uniform(0.1, 0.9);
    const double deep = random.uniform(0.15, 0.95);
    const cv::Vec3d front = at.left + across * (at.right - at.left);
    const cv::Vec3d back = at.left_back + across * (at.right_back - at.left_back);
    const auto tree = static_cast<std::size_t>(random.index(static_cast<int>(sprites.trees.size())));
    place_sprite(scene, sprites.trees[tree], front + deep * (back - front), moment, random.chance(0.5),
                 sprites.soft_shadow);
  }
}

}  // namespace sailmap::simulate
