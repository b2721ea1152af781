#include "facade_style.hpp"

#include <array>
#include <cstddef>

namespace sailmap::simulate {
namespace {

const std::array<Colour, 22>& plasters() {
  static const std::array<Colour, 22> colours = {
      rgb(226, 196, 142), rgb(205, 148, 96),  rgb(214, 128, 104), rgb(236, 222, 192), rgb(232, 230, 222),
      rgb(168, 188, 204), rgb(176, 204, 180), rgb(152, 166, 132), rgb(172, 76, 62),   rgb(160, 160, 158),
      rgb(190, 176, 206), rgb(238, 212, 122), rgb(84, 146, 148),  rgb(76, 92, 132),   rgb(224, 168, 160),
      rgb(206, 190, 166), rgb(120, 134, 110), rgb(196, 104, 58),  rgb(140, 120, 104), rgb(244, 240, 232),
      rgb(128, 176, 208), rgb(210, 160, 60)};
  return colours;
}

Colour wall_colour(Material material, Random& random) {
  const double light = random.uniform(0.85, 1.08);
  switch (material) {
    case Material::brick:
      return scaled(blend(rgb(158, 78, 58), rgb(196, 158, 112), random.uniform()), light);
    case Material::stone:
      return scaled(blend(rgb(176, 166, 146), rgb(138, 142, 146), random.uniform()), light);
    case Material::timber:
      return scaled(blend(rgb(238, 230, 210), rgb(222, 186, 130), random.uniform()), light);
    case Material::panels: {
      const Colour tone = from_hsv(random.uniform(), 0.5, 0.75);
      return scaled(blend(rgb(188, 188, 184), tone, random.uniform(0, 0.6)), light);
    }
    case Material::glass:
      return scaled(blend(rgb(84, 112, 132), rgb(96, 130, 118), random.uniform()), light);
    default:
      return scaled(plasters()[static_cast<std::size_t>(random.index(22))], light);
  }
}

Material pick_material(Random& random) {
  constexpr std::array<Material, 12> often = {Material::plaster, Material::plaster, Material::plaster,
                                              Material::plaster, Material::plaster, Material::brick,
                                              Material::brick,   Material::brick,   Material::stone,
                                              Material::timber,  Material::panels,  Material::glass};
  return often[static_cast<std::size_t>(random.index(static_cast<int>(often.size())))];
}

Ground pick_ground(Random& random) {
  constexpr std::array<Ground, 10> often = {Ground::shop,   Ground::shop,  Ground::shop,  Ground::shop,
                                            Ground::house,  Ground::house, Ground::house, Ground::garage,
                                            Ground::arcade, Ground::blind};
  return often[static_cast<std::size_t>(random.index(static_cast<int>(often.size())))];
}

}  // namespace

Colour vivid(Random& random) {
  const double hue = random.uniform();
  const double saturation = random.uniform(0.65, 0.95);
  return from_hsv(hue, saturation, random.uniform(0.55, 0.95));
}

Style draw_style(std::uint64_t seed) {
  Random random(seed);
  Style style;
  style.material = pick_material(random);
  style.ground = pick_ground(random);
  style.wall = wall_colour(style.material, random);
  style.trim = random.chance(0.6) ? blend(style.wall, rgb(245, 242, 232), 0.75) : scaled(style.wall, 0.6);
  style.frame = random.chance(0.6) ? rgb(240, 240, 236) : scaled(vivid(random), 0.5);
  style.accent = random.chance(0.5) ? scaled(vivid(random), 0.7) : blend(vivid(random), rgb(60, 70, 60), 0.5);
  style.glass = blend(rgb(44, 56, 70), rgb(96, 116, 132), random.uniform());
  style.bay = random.uniform(1.9, 3.4);
  style.window_width = style.bay * random.uniform(0.36, 0.6);
  style.window_height = random.uniform(1.25, 2.05);
  style.arched = random.chance(0.2);
  style.shutters = random.chance(0.35) && style.material != Material::panels;
  style.balconies = random.chance(0.25);
  style.lintels = random.chance(0.5);
  style.courses = random.chance(0.5);
  return style;
}

void lay_material(Canvas& canvas, const Style& style) {
  const double w = canvas.width();
  const double h = canvas.height();
  const double pixel = 1 / canvas.density();
  const auto joints = [&](double course, double length, double depth) {
    const Colour mortar = blend(style.wall, rgb(210, 205, 195), depth);
    bool shifted = false;
    for (const double y : steps(0, h, course)) {
      canvas.box(0, y, w, y + pixel, mortar);
      for (const double x : steps(shifted ? length / 2 : 0, w, length))
        canvas.box(x, y, x + pixel, y + course, mortar);
      shifted = !shifted;
    }
  };
  switch (style.material) {
    case Material::brick:
      joints(0.15, 0.45, 0.3);
      break;
    case Material::stone:
      joints(0.5, 1.1, 0.35);
      break;
    case Material::panels:
      for (const double y : steps(0.2, h, 1.5)) canvas.box(0, y, w, y + 0.05, scaled(style.wall, 0.7));
      for (const double x : steps(0, w, 1.8)) canvas.box(x, 0, x + 0.05, h, scaled(style.wall, 0.7));
      break;
    case Material::timber:
      for (const double y : steps(3.4, h, 1.5)) {
        canvas.box(0, y, w, y + 0.2, scaled(style.accent, 0.45));
        for (const double x : steps(0, w, style.bay / 2)) {
          canvas.box(x, y, x + 0.16, y + 1.5, scaled(style.accent, 0.45));
          if (static_cast<int>(x * 7 + y * 3) % 3 == 0)
            canvas.stroke(x, y, x + style.bay / 2, y + 1.5, 0.16, scaled(style.accent, 0.45));
        }
      }
      break;
    default:
      break;
  }
}

}  // namespace sailmap::simulate
