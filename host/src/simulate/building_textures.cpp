#include "building_textures.hpp"

#include <array>

#include "facade.hpp"
#include "facade_style.hpp"
#include "random.hpp"

namespace sailmap::simulate {
namespace {

Canvas draw_hedge() {
  Canvas canvas(8, 1.8, 40, clear());
  Random random(5);
  for (int leaf = 0; leaf < 2600; ++leaf) {
    const double x = random.uniform(0, 8);
    const double y = random.uniform(0, 1.62);
    canvas.ellipse(x, y, 0.1, 0.08, scaled(rgb(70, 112, 52), 0.5 + 0.4 * y + random.uniform(-0.15, 0.15)));
  }
  return canvas;
}

Canvas draw_railing() {
  Canvas canvas(8, 1.8, 40, clear());
  canvas.box(0, 0, 8, 0.5, rgb(150, 142, 130));
  canvas.box(0, 0.45, 8, 0.55, rgb(176, 170, 158));
  const Colour iron = rgb(36, 48, 42);
  for (const double y : {0.7, 1.5}) canvas.box(0, y, 8, y + 0.06, iron);
  for (const double x : steps(0.05, 8, 0.2)) canvas.box(x, 0.5, x + 0.05, 1.75, iron);
  return canvas;
}

Canvas draw_wall() {
  Style style;
  style.material = Material::stone;
  style.wall = rgb(168, 158, 140);
  Canvas canvas(8, 1.8, 40, style.wall);
  lay_material(canvas, style);
  canvas.box(0, 1.66, 8, 1.8, scaled(style.wall, 1.2));
  return canvas;
}

}  // namespace

std::vector<TexturePtr> make_side_walls(double density, const cv::Mat1b& noise_plate) {
  std::vector<TexturePtr> walls;
  walls.reserve(18);
  for (int i = 0; i < 18; ++i)
    walls.push_back(make_texture(draw_side_wall(hash(0, Subject::sprites, 20, i), density, noise_plate)));
  return walls;
}

std::vector<TexturePtr> make_roofs(double density, const cv::Mat1b& noise_plate) {
  const std::array<Colour, 5> colours = {rgb(168, 82, 56), rgb(92, 98, 112), rgb(130, 96, 74),
                                         rgb(104, 150, 132), rgb(188, 108, 70)};
  std::vector<TexturePtr> roofs;
  for (const Colour& colour : colours) {
    Canvas canvas(8, 4, density, colour);
    for (const double y : steps(0, 4, 0.3)) canvas.box(0, y, 8, y + 0.09, scaled(colour, 0.72));
    for (const double x : {2.0, 5.6}) {
      canvas.box(x - 0.55, 1.3, x + 0.55, 2.6, scaled(colour, 0.6));
      canvas.box(x - 0.42, 1.4, x + 0.42, 2.4, rgb(70, 84, 98));
      canvas.box(x - 0.03, 1.4, x + 0.03, 2.4, rgb(230, 230, 225));
    }
    canvas.weather(noise_plate, {0, 0}, 0.2, 0.2);
    roofs.push_back(make_texture(canvas.picture()));
  }
  return roofs;
}

std::vector<TexturePtr> make_hanging_signs() {
  std::vector<TexturePtr> signs;
  for (int i = 0; i < 20; ++i) {
    Random random(hash(0, Subject::sprites, 21, i));
    Canvas canvas(0.9, 0.9, 80, clear());
    const Colour paint = vivid(random);
    const Colour other = random.chance(0.5) ? rgb(250, 248, 238) : vivid(random);
    switch (random.index(3)) {
      case 0:
        canvas.ellipse(0.45, 0.45, 0.44, 0.44, paint);
        canvas.ellipse(0.45, 0.45, 0.28, 0.28, other);
        break;
      case 1:
        draw_sign(canvas, {0, 0.2, 0.9, 0.7}, random);
        break;
      default:
        canvas.box(0, 0, 0.9, 0.9, paint);
        canvas.polygon({{0.12, 0.15}, {0.78, 0.15}, {0.45, 0.8}}, other);
    }
    signs.push_back(make_texture(canvas.picture()));
  }
  return signs;
}

std::vector<TexturePtr> make_fences(const cv::Mat1b& noise_plate) {
  std::vector<TexturePtr> fences;
  for (Canvas canvas : {draw_hedge(), draw_railing(), draw_wall()}) {
    canvas.weather(noise_plate, {0, 0}, 0.15, 0.15);
    fences.push_back(make_texture(canvas.picture()));
  }
  return fences;
}

}  // namespace sailmap::simulate
