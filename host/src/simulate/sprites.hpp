// Things that look the same from every side: trees, people, furniture of the street.
#pragma once

#include <cstdint>
#include <vector>

#include "texture.hpp"

namespace sailmap::simulate {

// A picture that always faces the camera, standing on the ground.
struct Sprite {
  TexturePtr texture;
  double width = 1;  // metres
  double height = 1;
};

struct Sprites {
  std::vector<Sprite> trees, bushes, people, furniture;
  Sprite lamp;
  Sprite soft_shadow;  // a dark disc with a soft edge, to lie on the ground
};

// The same for every world.
Sprites make_sprites();

}  // namespace sailmap::simulate
