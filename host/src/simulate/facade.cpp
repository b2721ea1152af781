#include "facade.hpp"

#include <algorithm>
#include <cmath>

#include "facade_style.hpp"

namespace sailmap::simulate {
namespace {

constexpr double ground_height = 3.5;

void draw_glass_front(Canvas& canvas, const FacadePlan& plan, const Style& style, Random& random) {
  const double storey = 3.1;
  for (const double y : steps(0.3, plan.eaves - 0.4, storey)) {
    for (const double x : steps(0.15, plan.width - 0.3, style.bay)) {
      const double x1 = std::min(x + style.bay - 0.12, plan.width - 0.15);
      const double y1 = std::min(y + storey - 0.6, plan.eaves - 0.3);
      canvas.box(x, y, x1, y1, scaled(style.glass, random.uniform(0.8, 1.7)));
      canvas.shade(x, y, x1, y1, 0.8, 1.4);
      canvas.box(x, y1, x1, std::min(y1 + 0.5, plan.eaves), scaled(style.accent, random.uniform(0.8, 1.2)));
    }
  }
}

void draw_storeys(Canvas& canvas, const FacadePlan& plan, const Style& style, Random& random) {
  const int storeys = static_cast<int>((plan.eaves - ground_height) / 2.8);
  if (storeys < 1) return;
  const double each = (plan.eaves - ground_height) / storeys;
  const double spare = style.shutters ? 1.0 : 0.6;
  const int bays =
      std::max(1, static_cast<int>((plan.width - spare) / std::max(style.bay, style.window_width * 2)));
  for (int storey = 0; storey < storeys; ++storey) {
    const double y = ground_height + storey * each;
    if (style.courses) {
      canvas.box(0, y - 0.1, plan.width, y + 0.1, style.trim);
      canvas.shade(0, y - 0.25, plan.width, y - 0.1, 0.95, 0.7);
    }
    for (int bay = 0; bay < bays; ++bay) {
      const double x = spare / 2 + (plan.width - spare) * (bay + 0.5) / bays;
      const double tall = std::min(style.window_height, each - 1.1);
      draw_window(canvas, {x - style.window_width / 2, y + 0.75, x + style.window_width / 2, y + 0.75 + tall},
                  style, random);
    }
  }
}

// One thing that sets this house apart from the others of its style.
void draw_landmark(Canvas& canvas, const FacadePlan& plan, const Style& style, Random& random) {
  const double w = plan.width;
  const double upper = plan.eaves - ground_height;
  const double draw = random.uniform();
  if (draw < 0.14 && upper > 3) {
    const double x = random.uniform(0.3, w - 1.4);  // a banner down the front
    const Colour cloth = vivid(random);
    const Colour other = vivid(random);
    canvas.box(x, ground_height + 0.2, x + 1.1, plan.eaves - 0.5, cloth);
    for (const double y : steps(ground_height + 0.2, plan.eaves - 0.9, 1.6))
      canvas.box(x, y, x + 1.1, y + 0.6, other);
  } else if (draw < 0.26 && upper > 2) {
    const double y = random.uniform(ground_height + 0.2, plan.eaves - 1.5);
    draw_sign(canvas, {w * 0.15, y, w * 0.85, y + 1.2}, random);
  } else if (draw < 0.34 && upper > 4) {
    draw_mural(canvas, {0.3, ground_height + 0.3, w * random.uniform(0.4, 0.95), plan.eaves - 0.5}, random);
  } else if (draw < 0.42) {
    for (int leaf = 0; leaf < 220; ++leaf) {  // ivy
      const double reach = w * random.uniform();
      const double x = reach * random.uniform();
      const double y = plan.eaves * random.uniform() * (1 - 0.7 * x / w);
      canvas.ellipse(x, y, 0.22, 0.2, scaled(rgb(62, 98, 42), random.uniform(0.6, 1.4)));
    }
  } else if (draw < 0.47 && upper > 2) {
    const double y = plan.eaves - 1.1;
    canvas.ellipse(w / 2, y, 0.8, 0.8, style.accent);
    canvas.ellipse(w / 2, y, 0.68, 0.68, rgb(245, 242, 230));
    canvas.stroke(w / 2, y, w / 2, y + 0.55, 0.09, rgb(20, 20, 20));
    canvas.stroke(w / 2, y, w / 2 + 0.35, y - 0.2, 0.09, rgb(20, 20, 20));
  }
}

void draw_cornice(Canvas& canvas, const FacadePlan& plan, const Style& style) {
  canvas.box(0, plan.eaves - 0.35, plan.width, plan.eaves, style.trim);
  canvas.shade(0, plan.eaves - 0.6, plan.width, plan.eaves - 0.35, 1, 0.6);
  const double pipe = plan.width - 0.2;
  canvas.box(pipe, 0, pipe + 0.1, plan.eaves - 0.3, scaled(style.trim, 0.6));
}

// Leaves only the gable above the eaves.
void cut_gable(Canvas& canvas, const FacadePlan& plan, const Style& style) {
  const double w = plan.width;
  const double top = plan.eaves + plan.rise;
  if (plan.roof == RoofShape::gable) {
    canvas.ellipse(w / 2, plan.eaves + plan.rise * 0.3, 0.45, 0.45, style.frame);
    canvas.ellipse(w / 2, plan.eaves + plan.rise * 0.3, 0.36, 0.36, style.glass);
    canvas.stroke(0, plan.eaves, w / 2, top, 0.5, scaled(style.trim, 0.8));
    canvas.stroke(w, plan.eaves, w / 2, top, 0.5, scaled(style.trim, 0.8));
    canvas.polygon({{-0.1, plan.eaves}, {w / 2, top}, {-0.1, top + 0.1}}, clear());
    canvas.polygon({{w + 0.1, plan.eaves}, {w / 2, top}, {w + 0.1, top + 0.1}}, clear());
  } else if (plan.roof == RoofShape::stepped) {
    constexpr int steps = 5;
    for (int i = 0; i < steps; ++i) {
      const double y0 = plan.eaves + plan.rise * i / steps;
      const double inset = w * 0.45 * (i + 0.4) / steps;
      const double y1 = i + 1 == steps ? top + 0.1 : y0 + plan.rise / steps;
      canvas.box(inset, y1 - 0.2, w - inset, y1, style.trim);
      canvas.box(-0.1, y0, inset, y1, clear());
      canvas.box(w - inset, y0, w + 0.1, y1, clear());
    }
    canvas.box(w / 2 - 0.4, plan.eaves + 0.3, w / 2 + 0.4, plan.eaves + 1.3, style.glass);
  }
}

}  // namespace

cv::Mat4b draw_facade(const FacadePlan& plan, double density, const cv::Mat1b& noise_plate) {
  const Style style = draw_style(plan.style);
  Random random(plan.detail);
  Canvas canvas(plan.width, plan.eaves + plan.rise, density, style.wall);
  lay_material(canvas, style);
  if (style.material == Material::glass) {
    draw_glass_front(canvas, plan, style, random);
  } else {
    draw_storeys(canvas, plan, style, random);
  }
  draw_ground_floor(canvas, {0, 0, plan.width, std::min(ground_height - 0.15, plan.eaves)}, style, random);
  draw_cornice(canvas, plan, style);
  draw_landmark(canvas, plan, style, random);
  canvas.shade(0, 0, plan.width, 1.2, 0.72, 1.0);  // splashes and soot near the ground
  canvas.weather(noise_plate, {random.index(256), random.index(256)}, 0.12, 0.22);
  cut_gable(canvas, plan, style);
  return canvas.picture();
}

cv::Vec3f wall_tint(std::uint64_t style) {
  const Colour wall = draw_style(style).wall;
  return {static_cast<float>(wall[0] / 235), static_cast<float>(wall[1] / 235),
          static_cast<float>(wall[2] / 235)};
}

cv::Mat4b draw_side_wall(std::uint64_t seed, double density, const cv::Mat1b& noise_plate) {
  Random random(seed);
  Canvas canvas(8, 12, density, rgb(214, 211, 204));
  const Style style = draw_style(random.next());
  const double draw = random.uniform();
  if (draw < 0.3) {
    draw_mural(canvas, {0.8, random.uniform(1.5, 3), 7.2, random.uniform(6, 9)}, random);
  } else if (draw < 0.6) {
    const double y = random.uniform(3, 6);
    draw_sign(canvas, {0.7, y, 7.3, y + random.uniform(1.5, 2.6)}, random);
  } else {
    for (const double y : steps(4, 11, 3))
      for (const double x : {2.2, 5.6})
        if (random.chance(0.6)) draw_window(canvas, {x - 0.5, y, x + 0.5, y + 1.4}, style, random);
  }
  canvas.shade(0, 0, 8, 2, 0.7, 1.0);
  canvas.weather(noise_plate, {random.index(256), random.index(256)}, 0.14, 0.35);
  return canvas.picture();
}

}  // namespace sailmap::simulate
