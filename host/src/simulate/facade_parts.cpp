#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "facade_style.hpp"

namespace sailmap::simulate {
namespace {

const std::string& shop_name(Random& random) {
  static const std::array<std::string, 44> names = {
      "CAFE",  "BAKERY", "HOTEL",   "BAR",    "BOOKS", "PIZZA",  "MARKET", "BANK",  "FLORIST",
      "OPTIK", "CINEMA", "TAXI",    "MUSEUM", "SHOES", "TOYS",   "WINE",   "RADIO", "TABAC",
      "POST",  "MUSIC",  "GARAGE",  "SUSHI",  "KEBAB", "BISTRO", "SALON",  "OPERA", "CYCLES",
      "TEA",   "PHARMA", "JAZZ",    "LUNA",   "ROMA",  "VERDE",  "OSLO",   "LOTTO", "HATS",
      "LAMPS", "FISH",   "GALERIE", "MODE",   "ANTIK", "PUB",    "ZOO",    "24 H"};
  return names[static_cast<std::size_t>(random.index(static_cast<int>(names.size())))];
}

Colour ink_on(const Colour& ground) {
  const double light = 0.114 * ground[0] + 0.587 * ground[1] + 0.299 * ground[2];
  return light > 130 ? rgb(28, 24, 30) : rgb(250, 246, 230);
}

void draw_glass(Canvas& canvas, const Area& a, const Style& style, Random& random) {
  canvas.box(a.x0, a.y0, a.x1, a.y1, style.glass);
  canvas.shade(a.x0, a.y0, a.x1, a.y1, 0.8, random.uniform(1.2, 2.0));  // the sky in the upper part
  if (random.chance(0.4)) {
    const Colour curtain = blend(rgb(220, 216, 205), vivid(random), 0.2);
    const double part = a.width() * random.uniform(0.12, 0.3);
    canvas.box(a.x0, a.y0, a.x0 + part, a.y1, curtain);
    canvas.box(a.x1 - part, a.y0, a.x1, a.y1, curtain);
  } else if (random.chance(0.15)) {
    canvas.box(a.x0, a.y0, a.x1, a.y1, rgb(246, 214, 136));
  } else if (random.chance(0.2)) {
    canvas.box(a.x0, a.y1 - a.height() * random.uniform(0.2, 0.8), a.x1, a.y1, rgb(205, 200, 188));
  }
}

void draw_shutters(Canvas& canvas, const Area& a, const Style& style) {
  const double leaf = a.width() * 0.42;
  for (const double x : {a.x0 - leaf - 0.05, a.x1 + 0.05}) {
    canvas.box(x, a.y0, x + leaf, a.y1, style.accent);
    for (const double y : steps(a.y0 + 0.1, a.y1 - 0.1, 0.2))
      canvas.box(x + 0.06, y, x + leaf - 0.06, y + 0.07, scaled(style.accent, 0.72));
  }
}

void draw_balcony(Canvas& canvas, const Area& a) {
  const Colour iron = rgb(38, 40, 44);
  canvas.box(a.x0 - 0.3, a.y0 - 0.2, a.x1 + 0.3, a.y0 - 0.05, rgb(150, 146, 138));
  canvas.box(a.x0 - 0.3, a.y0 + 0.8, a.x1 + 0.3, a.y0 + 0.87, iron);
  for (const double x : steps(a.x0 - 0.28, a.x1 + 0.3, 0.16))
    canvas.box(x, a.y0 - 0.05, x + 0.05, a.y0 + 0.8, iron);
  canvas.shade(a.x0 - 0.3, a.y0 - 0.6, a.x1 + 0.3, a.y0 - 0.2, 0.95, 0.7);
}

void draw_awning(Canvas& canvas, const Area& a, const Colour& colour, Random& random) {
  const bool striped = random.chance(0.6);
  const int strips = std::max(2, static_cast<int>(a.width() / 0.5));
  for (int i = 0; i < strips; ++i) {
    const double x0 = a.x0 + a.width() * i / strips;
    const double x1 = a.x0 + a.width() * (i + 1) / strips;
    const Colour strip = striped && i % 2 == 1 ? rgb(240, 238, 228) : colour;
    canvas.box(x0, a.y0, x1, a.y1, strip);
    canvas.ellipse((x0 + x1) / 2, a.y0, (x1 - x0) / 2, 0.12, scaled(strip, 0.85));
  }
  canvas.shade(a.x0, a.y0, a.x1, a.y1, 0.85, 1.15);
  canvas.shade(a.x0, a.y0 - 0.7, a.x1, a.y0 - 0.1, 0.9, 0.55);  // what it casts on the window
}

void draw_shop(Canvas& canvas, const Area& a, const Style& style, Random& random) {
  const Colour paint = vivid(random);
  const double door = random.chance(0.5) ? a.x0 + 0.4 : a.x1 - 1.5;
  canvas.box(a.x0, a.y0, a.x1, a.y1, scaled(paint, 0.6));
  const int panes = std::max(1, static_cast<int>(a.width() / 2.2));
  for (int i = 0; i < panes; ++i) {
    const Area pane{a.x0 + 0.3 + (a.width() - 0.6) * i / panes, a.y0 + 0.5,
                    a.x0 + 0.15 + (a.width() - 0.6) * (i + 1) / panes, a.y0 + 2.5};
    draw_glass(canvas, pane, style, random);
    for (int ware = 0; ware < 6; ++ware) {
      const double x = random.uniform(pane.x0 + 0.15, std::max(pane.x0 + 0.16, pane.x1 - 0.15));
      const double tall = random.uniform(0.15, 0.7);
      canvas.box(x - 0.12, pane.y0, x + 0.12, pane.y0 + tall, vivid(random));
    }
  }
  draw_door(canvas, {door, a.y0, door + 1.1, a.y0 + 2.4}, scaled(paint, 0.8), style);
  const Area board{a.x0 + 0.15, a.y1 - 0.85, a.x1 - 0.15, a.y1 - 0.1};
  canvas.box(board.x0, board.y0, board.x1, board.y1, paint);
  canvas.text(shop_name(random), board.x0 + 0.2, board.y0 + 0.14, board.x1 - 0.2, board.y1 - 0.14,
              ink_on(paint));
  if (random.chance(0.5))
    draw_awning(canvas, {a.x0 + 0.2, a.y0 + 1.95, a.x1 - 0.2, a.y0 + 2.45}, vivid(random), random);
}

void draw_arcade(Canvas& canvas, const Area& a, const Style& style) {
  const int arches = std::max(1, static_cast<int>(a.width() / 2.8));
  const double each = a.width() / arches;
  for (int i = 0; i < arches; ++i) {
    const double x = a.x0 + each * (i + 0.5);
    const double half = each * 0.36;
    canvas.ellipse(x, a.y0 + 1.9, half + 0.15, half + 0.15, style.trim);
    canvas.box(x - half - 0.15, a.y0, x + half + 0.15, a.y0 + 1.9, style.trim);
    canvas.ellipse(x, a.y0 + 1.9, half, half, rgb(40, 36, 36));
    canvas.box(x - half, a.y0, x + half, a.y0 + 1.9, rgb(46, 42, 42));
    canvas.shade(x - half, a.y0, x + half, a.y0 + 1.9, 1.7, 0.9);
  }
}

void draw_garage(Canvas& canvas, const Area& a, const Style& style, Random& random) {
  const Colour paint = random.chance(0.5) ? style.accent : blend(rgb(150, 150, 150), vivid(random), 0.4);
  const double width = std::min(3.2, a.width() - 1.2);
  const double x = a.x0 + 0.6 + (a.width() - 1.2 - width) * random.uniform();
  canvas.box(x - 0.15, a.y0, x + width + 0.15, a.y0 + 2.75, style.trim);
  canvas.box(x, a.y0, x + width, a.y0 + 2.6, paint);
  for (const double y : steps(a.y0 + 0.25, a.y0 + 2.6, 0.3))
    canvas.box(x, y, x + width, y + 0.05, scaled(paint, 0.7));
}

void draw_house_front(Canvas& canvas, const Area& a, const Style& style, Random& random) {
  const int bays = std::max(1, static_cast<int>(a.width() / std::max(2.2, style.bay)));
  const int door = random.index(bays);
  for (int i = 0; i < bays; ++i) {
    const double x = a.x0 + a.width() * (i + 0.5) / bays;
    if (i == door) {
      canvas.box(x - 1.1, a.y0, x + 1.1, a.y0 + 0.18, rgb(150, 146, 140));
      draw_door(canvas, {x - 0.6, a.y0 + 0.18, x + 0.6, a.y0 + 2.5}, scaled(vivid(random), 0.75), style);
    } else {
      draw_window(canvas, {x - style.window_width / 2, a.y0 + 1.0, x + style.window_width / 2, a.y0 + 2.5},
                  style, random);
    }
  }
}

}  // namespace

void draw_door(Canvas& canvas, const Area& a, const Colour& colour, const Style& style) {
  canvas.box(a.x0 - 0.12, a.y0, a.x1 + 0.12, a.y1 + 0.12, style.trim);
  canvas.box(a.x0, a.y0, a.x1, a.y1, colour);
  canvas.box(a.x0 + 0.15, a.y1 - 0.55, a.x1 - 0.15, a.y1 - 0.12, style.glass);
  for (const double y : {a.y0 + 0.2, a.y0 + 1.0})
    canvas.box(a.x0 + 0.18, y, a.x1 - 0.18, y + 0.6, scaled(colour, 0.75));
  canvas.ellipse(a.x1 - 0.12, a.y0 + 0.95, 0.05, 0.05, rgb(230, 200, 90));
}

void draw_window(Canvas& canvas, const Area& a, const Style& style, Random& random) {
  const double frame = 0.08;
  if (style.lintels) {
    canvas.box(a.x0 - 0.2, a.y1 + frame, a.x1 + 0.2, a.y1 + 0.28, style.trim);
    canvas.shade(a.x0 - 0.2, a.y1 - 0.02, a.x1 + 0.2, a.y1 + frame, 0.6, 0.6);
  }
  canvas.box(a.x0 - 0.14, a.y0 - 0.14, a.x1 + 0.14, a.y0, style.trim);
  canvas.shade(a.x0 - 0.1, a.y0 - 0.5, a.x1 + 0.1, a.y0 - 0.14, 1.0, 0.75);  // stains below the sill
  if (style.arched)
    canvas.ellipse(a.middle(), a.y1, a.width() / 2 + frame, a.width() / 2 + frame, style.frame);
  canvas.box(a.x0 - frame, a.y0, a.x1 + frame, a.y1 + (style.arched ? 0 : frame), style.frame);
  if (style.arched) canvas.ellipse(a.middle(), a.y1, a.width() / 2, a.width() / 2, scaled(style.glass, 1.3));
  draw_glass(canvas, a, style, random);
  canvas.shade(a.x0, a.y1 - 0.15, a.x1, a.y1, 1, 0.5);  // the reveal
  canvas.box(a.middle() - 0.04, a.y0, a.middle() + 0.04, a.y1, style.frame);
  canvas.box(a.x0, a.y0 + a.height() * 0.62, a.x1, a.y0 + a.height() * 0.62 + 0.06, style.frame);
  if (style.shutters) draw_shutters(canvas, a, style);
  if (style.balconies && random.chance(0.7)) {
    draw_balcony(canvas, a);
  } else if (random.chance(0.12)) {
    for (const double x : steps(a.x0, a.x1, 0.18))
      canvas.ellipse(x + 0.09, a.y0 + 0.05, 0.12, 0.12,
                     random.chance(0.5) ? rgb(70, 120, 50) : vivid(random));
  }
}

void draw_ground_floor(Canvas& canvas, const Area& area, const Style& style, Random& random) {
  canvas.box(area.x0, area.y0, area.x1, area.y0 + 0.5, scaled(style.wall, 0.72));
  switch (style.ground) {
    case Ground::shop:
      draw_shop(canvas, area, style, random);
      break;
    case Ground::arcade:
      draw_arcade(canvas, area, style);
      break;
    case Ground::garage:
      draw_garage(canvas, area, style, random);
      break;
    case Ground::blind:
      draw_mural(canvas, {area.x0 + 0.5, area.y0 + 0.3, area.x1 - 0.5, area.y1 - 0.3}, random);
      break;
    default:
      draw_house_front(canvas, area, style, random);
  }
}

void draw_sign(Canvas& canvas, const Area& area, Random& random) {
  const Colour paint = vivid(random);
  const double margin = 0.12 * area.height();
  canvas.box(area.x0, area.y0, area.x1, area.y1, ink_on(paint));
  canvas.box(area.x0 + margin / 2, area.y0 + margin / 2, area.x1 - margin / 2, area.y1 - margin / 2, paint);
  canvas.text(shop_name(random), area.x0 + 2 * margin, area.y0 + 2 * margin, area.x1 - 2 * margin,
              area.y1 - 2 * margin, ink_on(paint));
}

void draw_mural(Canvas& canvas, const Area& a, Random& random) {
  const Colour strong = vivid(random);
  canvas.box(a.x0, a.y0, a.x1, a.y1, blend(strong, rgb(230, 225, 215), random.uniform(0.2, 0.8)));
  const double size = std::min(a.width(), a.height());
  for (int figure = 0; figure < 7; ++figure) {
    const double r = size * random.uniform(0.08, 0.32);
    const double x = random.uniform(a.x0 + r, std::max(a.x0 + r, a.x1 - r));
    const double y = random.uniform(a.y0 + r, std::max(a.y0 + r, a.y1 - r));
    const Colour colour = vivid(random);
    const int kind = random.index(3);
    if (kind == 0) canvas.ellipse(x, y, r, r, colour);
    if (kind == 1)
      canvas.polygon({{x - r, y - r}, {x + r, y - r}, {x + r * random.uniform(-1, 1), y + r}}, colour);
    if (kind == 2) canvas.box(x - r, y - 0.5 * r, x + r, y + 0.5 * r, colour);
  }
}

}  // namespace sailmap::simulate
