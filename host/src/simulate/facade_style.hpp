// The choices that make a style of building, and the parts drawn by it.
#pragma once

#include <cstdint>

#include "canvas.hpp"
#include "random.hpp"

namespace sailmap::simulate {

enum class Material : std::uint8_t { plaster, brick, stone, timber, panels, glass };
enum class Ground : std::uint8_t { shop, house, garage, arcade, blind };

struct Style {
  Material material = Material::plaster;
  Ground ground = Ground::house;
  Colour wall, trim, frame, accent, glass;
  double bay = 2.6;  // metres of wall for each window
  double window_width = 1.1;
  double window_height = 1.6;
  bool arched = false;
  bool shutters = false;
  bool balconies = false;
  bool lintels = false;
  bool courses = false;  // a band at each storey
};

Style draw_style(std::uint64_t seed);

// A box of wall, metres.
struct Area {
  double x0, y0, x1, y1;
  [[nodiscard]] double width() const { return x1 - x0; }
  [[nodiscard]] double height() const { return y1 - y0; }
  [[nodiscard]] double middle() const { return (x0 + x1) / 2; }
};

// Joints, beams or panes over the whole canvas.
void lay_material(Canvas& canvas, const Style& style);
// A window with all that belongs to it; `area` is the opening.
void draw_window(Canvas& canvas, const Area& area, const Style& style, Random& random);
void draw_door(Canvas& canvas, const Area& area, const Colour& colour, const Style& style);
// Everything below the first floor.
void draw_ground_floor(Canvas& canvas, const Area& area, const Style& style, Random& random);
// Large figures in strong colours.
void draw_mural(Canvas& canvas, const Area& area, Random& random);
// A painted board with words.
void draw_sign(Canvas& canvas, const Area& area, Random& random);
// Strong colours that are seen from far.
Colour vivid(Random& random);

}  // namespace sailmap::simulate
