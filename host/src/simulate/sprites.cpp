#include "sprites.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "canvas.hpp"
#include "random.hpp"

namespace sailmap::simulate {
namespace {

Sprite finish(const Canvas& canvas) {
  return {make_texture(canvas.picture()), canvas.width(), canvas.height()};
}

enum class Crown : std::uint8_t { round, tall, cone };

// Leaves in clumps, dark below and light above.
void draw_leaves(Canvas& canvas, Crown crown, double bottom, const Colour& leaf, Random& random) {
  const double middle = canvas.width() / 2;
  const double tall = canvas.height() - bottom;
  const int clumps = 620;
  for (int i = 0; i < clumps; ++i) {
    const double part = random.uniform(0.04, 0.95);
    double half = 0.46 * canvas.width() * std::sqrt(std::max(0.0, 1 - std::pow(2 * part - 1, 2)));
    if (crown == Crown::cone) half = 0.44 * canvas.width() * (1 - part);
    if (crown == Crown::tall) half *= 0.85;
    const double across = random.uniform(-1, 1);
    const double light = 0.45 + 0.65 * part - 0.15 * across + 0.3 * (static_cast<double>(i) / clumps - 0.5) +
                         random.uniform(-0.12, 0.12);
    const double radius = canvas.width() * random.uniform(0.014, 0.05);
    canvas.ellipse(middle + across * half, bottom + part * tall, radius, 0.8 * radius,
                   scaled(leaf, std::max(0.25, light)));
  }
}

Sprite make_tree(std::uint64_t seed) {
  Random random(seed);
  const auto crown = static_cast<Crown>(random.index(3));
  const double width = crown == Crown::round ? random.uniform(3.5, 5.5) : random.uniform(1.8, 2.8);
  const double height = random.uniform(4.5, 8);
  Canvas canvas(width, height, 40, clear());
  const double stem = crown == Crown::cone ? 0.6 : height * random.uniform(0.28, 0.4);
  const double thick = random.uniform(0.12, 0.22);
  const Colour bark = scaled(rgb(98, 78, 60), random.uniform(0.7, 1.3));
  const double middle = width / 2;
  canvas.polygon({{middle - thick, 0},
                  {middle + thick, 0},
                  {middle + 0.6 * thick, height * 0.7},
                  {middle - 0.6 * thick, height * 0.7}},
                 bark);
  for (int i = 0; i < 5; ++i)
    canvas.stroke(middle, stem * random.uniform(0.9, 1.2), middle + width * random.uniform(-0.3, 0.3),
                  height * random.uniform(0.55, 0.75), 0.1, bark);
  const double season = random.uniform();
  Colour leaf = rgb(86 + 40 * random.uniform(), 132, 56);
  if (season > 0.8) leaf = rgb(196, 138, 48);
  if (season > 0.92) leaf = rgb(214, 150, 170);
  if (crown == Crown::cone) leaf = rgb(58, 100, 62);
  draw_leaves(canvas, crown, stem, leaf, random);
  return finish(canvas);
}

Sprite make_bush(std::uint64_t seed) {
  Random random(seed);
  Canvas canvas(2.2, random.uniform(0.9, 1.6), 48, clear());
  draw_leaves(canvas, Crown::round, -0.5 * canvas.height(), rgb(80 + 50 * random.uniform(), 128, 60), random);
  return finish(canvas);
}

Sprite make_person(std::uint64_t seed) {
  Random random(seed);
  const double tall = random.uniform(1.55, 1.9);
  Canvas canvas(0.8, tall, 90, clear());
  const Colour coat = from_hsv(random.uniform(), random.uniform(0.2, 0.9), 0.75);
  const Colour legs =
      scaled(blend(rgb(50, 60, 90), rgb(120, 100, 80), random.uniform()), random.uniform(0.5, 1.1));
  const Colour skin = blend(rgb(238, 196, 160), rgb(110, 72, 50), random.uniform());
  const Colour hair = blend(rgb(40, 28, 22), rgb(200, 160, 90), random.uniform());
  const double stride = random.uniform(0.08, 0.24);
  const double hip = 0.5 * tall;
  const double shoulder = 0.82 * tall;
  for (const double side : {-1.0, 1.0}) {
    canvas.stroke(0.4 + 0.05 * side, hip, 0.4 + stride * side, 0.03, 0.15, legs);
    canvas.box(0.4 + stride * side - 0.07, 0, 0.4 + stride * side + 0.11, 0.08, rgb(30, 26, 26));
    canvas.stroke(0.4 + 0.17 * side, shoulder - 0.04, 0.4 + (0.2 + 0.3 * stride) * side, hip, 0.1,
                  scaled(coat, 0.8));
  }
  const bool skirt = random.chance(0.3);
  canvas.polygon({{0.4 - (skirt ? 0.26 : 0.17), hip - (skirt ? 0.3 : 0.08)},
                  {0.4 + (skirt ? 0.26 : 0.17), hip - (skirt ? 0.3 : 0.08)},
                  {0.6, shoulder},
                  {0.2, shoulder}},
                 coat);
  canvas.shade(0.1, hip - 0.1, 0.7, shoulder, 0.75, 1.1);
  if (random.chance(0.35))
    canvas.box(0.58, hip - 0.1, 0.76, hip + 0.22, from_hsv(random.uniform(), 0.7, 0.6));
  canvas.ellipse(0.4, tall - 0.14, 0.11, 0.135, hair);
  canvas.ellipse(0.4, tall - 0.165, 0.09, 0.11, skin);
  return finish(canvas);
}

Sprite make_traffic_sign(std::uint64_t seed) {
  Random random(seed);
  Canvas canvas(0.8, 2.7, 64, clear());
  canvas.box(0.37, 0, 0.43, 2.6, rgb(140, 142, 146));
  const Colour red = rgb(200, 24, 30);
  const Colour white = rgb(246, 246, 242);
  switch (random.index(4)) {
    case 0:
      canvas.ellipse(0.4, 2.3, 0.36, 0.36, red);
      canvas.ellipse(0.4, 2.3, 0.26, 0.26, white);
      canvas.text("30", 0.22, 2.16, 0.58, 2.44, rgb(10, 10, 10));
      break;
    case 1:
      canvas.polygon({{0.02, 1.98}, {0.78, 1.98}, {0.4, 2.68}}, red);
      canvas.polygon({{0.17, 2.07}, {0.63, 2.07}, {0.4, 2.5}}, white);
      break;
    case 2:
      canvas.ellipse(0.4, 2.3, 0.36, 0.36, red);
      canvas.box(0.15, 2.23, 0.65, 2.37, white);
      break;
    default:
      canvas.box(0.06, 1.96, 0.74, 2.66, rgb(20, 76, 176));
      canvas.text("P", 0.2, 2.06, 0.6, 2.56, white);
  }
  return finish(canvas);
}

Sprite make_column(std::uint64_t seed) {
  Random random(seed);  // an advertising column with posters
  Canvas canvas(1.3, 3, 64, clear());
  canvas.box(0.1, 0, 1.2, 2.7, rgb(92, 104, 96));
  for (const double y : steps(0.4, 2.3, 1.05)) {
    for (const double x : steps(0.14, 1.0, 0.54)) {
      const Colour paper = from_hsv(random.uniform(), 0.6, 0.9);
      canvas.box(x, y, x + 0.48, y + 0.95, paper);
      canvas.ellipse(x + 0.24, y + 0.6, 0.15, 0.2, from_hsv(random.uniform(), 0.9, 0.7));
      canvas.box(x + 0.06, y + 0.1, x + 0.42, y + 0.2, rgb(30, 30, 40));
    }
  }
  canvas.polygon({{0, 2.65}, {1.3, 2.65}, {0.65, 3}}, rgb(58, 72, 64));
  return finish(canvas);
}

Sprite make_parasol(std::uint64_t seed) {
  Random random(seed);  // with table and chairs
  Canvas canvas(2.6, 2.5, 48, clear());
  const Colour cloth = from_hsv(random.uniform(), 0.8, 0.85);
  canvas.box(1.27, 0, 1.33, 2.4, rgb(150, 130, 100));
  canvas.polygon({{0, 1.85}, {2.6, 1.85}, {1.3, 2.5}}, cloth);
  canvas.polygon({{0.85, 1.85}, {1.75, 1.85}, {1.3, 2.5}},
                 random.chance(0.5) ? rgb(244, 240, 230) : scaled(cloth, 0.8));
  canvas.box(0.8, 0.7, 1.8, 0.77, rgb(190, 150, 100));
  for (const double x : {0.45, 1.95}) {
    canvas.box(x, 0.4, x + 0.4, 0.46, scaled(cloth, 0.6));
    canvas.box(x < 1 ? x : x + 0.35, 0, x < 1 ? x + 0.05 : x + 0.4, 0.9, scaled(cloth, 0.6));
  }
  return finish(canvas);
}

Sprite make_box(std::uint64_t seed) {
  Random random(seed);  // letter box, bin, cabinet, telephone box
  const bool booth = random.chance(0.3);
  const double width = booth ? 0.95 : random.uniform(0.5, 0.8);
  const double height = booth ? 2.4 : random.uniform(0.9, 1.4);
  const Colour paint = from_hsv(random.chance(0.5) ? 0.0 : random.uniform(), 0.85, random.uniform(0.5, 0.85));
  Canvas canvas(width, height, 72, clear());
  canvas.box(0.03, 0.05, width - 0.03, height - 0.05, paint);
  canvas.shade(0, 0, width, height, 0.7, 1.15);
  if (booth) {
    for (const double y : steps(0.5, 2, 0.5))
      for (const double x : {0.14, 0.5}) canvas.box(x, y, x + 0.31, y + 0.42, rgb(150, 176, 186));
    canvas.box(0.12, 2.08, width - 0.12, 2.26, rgb(245, 245, 240));
  } else {
    canvas.box(0.1, height * 0.72, width - 0.1, height * 0.78, rgb(24, 24, 26));
    canvas.box(0.14, height * 0.4, width - 0.14, height * 0.6, rgb(240, 236, 220));
  }
  return finish(canvas);
}

Sprite make_lamp() {
  Canvas canvas(0.9, 5.4, 48, clear());
  const Colour iron = rgb(44, 50, 50);
  canvas.polygon({{0.37, 0}, {0.53, 0}, {0.48, 5}, {0.42, 5}}, iron);
  canvas.box(0.32, 0, 0.58, 0.6, iron);
  canvas.polygon({{0.3, 4.6}, {0.6, 4.6}, {0.72, 5.1}, {0.18, 5.1}}, rgb(248, 240, 206));
  canvas.polygon({{0.12, 5.1}, {0.78, 5.1}, {0.45, 5.36}}, iron);
  return finish(canvas);
}

Sprite make_soft_shadow() {
  cv::Mat4b picture(32, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const double r = std::hypot(x - 15.5, y - 15.5) / 16;
      picture(y, x) = cv::Vec4b(0, 0, 0, static_cast<uchar>(255 * std::clamp(1.6 - 1.7 * r, 0.0, 1.0)));
    }
  return {make_texture(picture), 1, 1};
}

}  // namespace

Sprites make_sprites() {
  Sprites sprites;
  for (int i = 0; i < 14; ++i) sprites.trees.push_back(make_tree(hash(0, Subject::sprites, 1, i)));
  for (int i = 0; i < 6; ++i) sprites.bushes.push_back(make_bush(hash(0, Subject::sprites, 2, i)));
  for (int i = 0; i < 28; ++i) sprites.people.push_back(make_person(hash(0, Subject::sprites, 3, i)));
  for (int i = 0; i < 6; ++i) {
    sprites.furniture.push_back(make_traffic_sign(hash(0, Subject::sprites, 4, i)));
    sprites.furniture.push_back(make_box(hash(0, Subject::sprites, 5, i)));
    sprites.furniture.push_back(make_column(hash(0, Subject::sprites, 6, i)));
    sprites.furniture.push_back(make_parasol(hash(0, Subject::sprites, 7, i)));
  }
  sprites.lamp = make_lamp();
  sprites.soft_shadow = make_soft_shadow();
  return sprites;
}

}  // namespace sailmap::simulate
