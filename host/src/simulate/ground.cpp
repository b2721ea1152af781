#include "ground.hpp"

#include <cmath>
#include <cstddef>

#include "canvas.hpp"
#include "random.hpp"

namespace sailmap::simulate {
namespace {

constexpr double strip_length = 1;  // metres
constexpr int strips_per_tile = 8;
constexpr double tile_length = strip_length * strips_per_tile;

void draw_pavement(Canvas& canvas, const StreetPlan& plan, const Colour& slab) {
  const double middle = canvas.width() / 2;
  for (const int side : {-1, 1}) {
    const double kerb = middle + side * plan.kerb;
    const double front = middle + side * plan.front;
    canvas.box(kerb, 0, front, tile_length, slab);
    for (const double y : steps(0, tile_length, 0.8))
      canvas.box(kerb, y, front, y + 0.04, scaled(slab, 0.78));
    for (const double x : steps(0.8, plan.front - plan.kerb, 0.8))
      canvas.box(kerb + side * x, 0, kerb + side * x + 0.04, tile_length, scaled(slab, 0.78));
    canvas.box(front - side * 0.5, 0, front, tile_length, scaled(slab, 0.75));
    canvas.box(kerb, 0, kerb + side * 0.22, tile_length, scaled(slab, 1.25));
    canvas.box(kerb - side * 0.3, 0, kerb, tile_length, rgb(70, 68, 66));
  }
}

void draw_setts(Canvas& canvas, const StreetPlan& plan, Random& random) {
  const double middle = canvas.width() / 2;
  for (const double y : steps(0, tile_length, 0.25))
    for (const double x : steps(middle - plan.kerb, middle + plan.kerb, 0.3))
      canvas.box(x, y, x + 0.26, y + 0.21, scaled(rgb(128, 120, 112), random.uniform(0.75, 1.2)));
}

// What makes one tile unlike another.
void draw_variant(Canvas& canvas, const StreetPlan& plan, int variant, Random& random) {
  const double middle = canvas.width() / 2;
  const Colour paint = rgb(222, 222, 214);
  switch (variant) {
    case 1:
      for (const double x : steps(-plan.kerb + 0.5, plan.kerb - 0.4, 1))
        canvas.box(middle + x, 2, middle + x + 0.5, 5, paint);
      break;
    case 2:
      for (const double x : {-0.35 * plan.kerb, 0.4 * plan.kerb}) {
        const double y = random.uniform(1, 7);
        canvas.ellipse(middle + x, y, 0.4, 0.4, rgb(52, 50, 50));
        canvas.ellipse(middle + x, y, 0.3, 0.3, rgb(78, 74, 72));
      }
      break;
    case 3:
      for (int i = 0; i < 3; ++i) {
        const double x = middle + plan.kerb * random.uniform(-0.8, 0.4);
        const double y = random.uniform(0, 5);
        canvas.box(x, y, x + random.uniform(0.8, 2.2), y + random.uniform(1, 3), rgb(66, 66, 68));
      }
      break;
    case 4: {
      const double x = middle - 0.5 * plan.kerb;
      canvas.box(x - 0.1, 2, x + 0.1, 4.5, paint);
      canvas.polygon({{x - 0.4, 4.4}, {x + 0.4, 4.4}, {x, 6}}, paint);
      break;
    }
    case 5: {
      double x = middle + plan.kerb * random.uniform(-0.7, 0.7);
      for (const double y : steps(0, tile_length, 0.7)) {
        const double next = x + random.uniform(-0.4, 0.4);
        canvas.stroke(x, y, next, y + 0.75, 0.06, rgb(48, 48, 50));
        x = next;
      }
      break;
    }
    case 6:
      for (int leaf = 0; leaf < 90; ++leaf) {
        const double x = random.uniform(0, canvas.width());
        const double y = random.uniform(0, tile_length);
        canvas.ellipse(x, y, 0.1, 0.08, blend(rgb(170, 120, 50), rgb(110, 120, 50), random.uniform()));
      }
      break;
    default:
      break;
  }
}

TexturePtr draw_tile(const StreetPlan& plan, int kind, int variant, double density, const cv::Mat1b& plate) {
  Random random(hash(0, Subject::ground, kind, variant));
  Canvas canvas(2 * plan.front, tile_length, density, kind == 0 ? rgb(98, 98, 102) : rgb(84, 78, 74));
  if (kind == 1) draw_setts(canvas, plan, random);
  const double middle = canvas.width() / 2;
  if (kind == 0) {
    for (const double track : {-0.68, -0.3, 0.3, 0.68})  // where the wheels roll
      canvas.box(middle + track * plan.kerb - 0.25, 0, middle + track * plan.kerb + 0.25, tile_length,
                 rgb(106, 106, 108));
    if (plan.wide && variant != 1)
      for (const double y : {1.0, 5.0})
        canvas.box(middle - 0.07, y, middle + 0.07, y + 2, rgb(216, 216, 206));
  }
  draw_variant(canvas, plan, variant, random);
  draw_pavement(canvas, plan, kind == 0 ? rgb(158, 152, 144) : rgb(168, 150, 130));
  const int column = random.index(256);
  canvas.weather(plate, {column, random.index(256)}, 0.16, 0.12);
  return make_texture(canvas.picture());
}

}  // namespace

Ground::Ground(std::uint64_t seed, const StreetPlan& plan, double density, const cv::Mat1b& noise_plate)
    : seed_(seed), plan_(plan) {
  for (int kind = 0; kind < kinds; ++kind)
    for (int variant = 0; variant < variants; ++variant)
      tiles_.push_back(draw_tile(plan, kind, variant, density, noise_plate));
  Canvas grass(16, tile_length, density / 2, rgb(98, 124, 62));
  grass.weather(noise_plate, {0, 0}, 0.35, 0.3);
  grass_ = make_texture(grass.picture());
}

const TexturePtr& Ground::tile(int strip) const {
  const int place = strip / strips_per_tile;
  const int district = place / 12;  // the paving changes about every hundred metres
  const int kind = unit(hash(seed_, Subject::ground, district)) < 0.35 ? 1 : 0;
  const int variant = Random(hash(seed_, Subject::ground, place, 1)).index(variants);
  return tiles_[static_cast<std::size_t>(kind * variants + variant)];
}

void Ground::place(double first, double last, const Lighting& lighting,
                   std::vector<Surface>& surfaces) const {
  const Route& route = *plan_.route;
  const int strips = static_cast<int>(std::lround(route.length() / strip_length));
  const double step = route.length() / strips;
  const cv::Vec3f tint = lighting.on({0, 0, 1});
  for (int i = static_cast<int>(std::floor(first / step)); i * step < last; ++i) {
    const RoutePoint from = route.at(i * step);
    const RoutePoint to = route.at((i + 1) * step);
    const int strip = ((i % strips) + strips) % strips;
    const auto add = [&](double right, double left, double texture_width, const TexturePtr& texture) {
      Surface s;
      s.corners = {from.beside(-right), to.beside(-right), to.beside(-left), from.beside(-left)};
      s.corner_count = 4;
      s.texture = texture;
      s.tint = tint;
      // The picture is straight: laid along the chord, its part of this strip between the strip's ends.
      const cv::Vec3d ahead = to.beside(0) - from.beside(0);
      const cv::Vec3d unit_right = cv::Vec3d(ahead[1], -ahead[0], 0) / cv::norm(ahead);
      s.right = texture_width * unit_right;
      s.up = strips_per_tile * ahead;
      s.origin = from.beside(0) + left * unit_right - (strip % strips_per_tile) * ahead;
      surfaces.push_back(s);
    };
    add(plan_.front, -plan_.front, 2 * plan_.front, tile(strip));
    const double curvature = from.curvature;
    const double to_left = plan_.front + room_behind(plan_, curvature, 1, 16);
    const double to_right = plan_.front + room_behind(plan_, curvature, -1, 16);
    add(-plan_.front, -to_left, 16, grass_);
    add(to_right, plan_.front, 16, grass_);
  }
}

}  // namespace sailmap::simulate
