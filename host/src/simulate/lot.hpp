// The plots along the street and what stands on each.
#pragma once

#include <cstdint>

#include "facade.hpp"
#include "street_plan.hpp"

namespace sailmap::simulate {

enum class Fence : std::uint8_t { hedge, railing, wall };

struct Lot {
  int side = 1;      // +1 left of the street, -1 right
  int index = 0;     // 0 .. lot_count-1, along the route
  double first = 0;  // metres along the route; may be outside 0 .. length
  double last = 0;
  bool garden = false;  // no building
  Fence fence = Fence::hedge;
  double setback = 0;  // metres behind the front line
  double eaves = 9;
  double rise = 3;  // of the roof
  RoofShape roof = RoofShape::pitched;
  std::uint64_t style = 0;
  std::uint64_t detail = 0;
};

// Lots on each side of the route.
int lot_count(const StreetPlan& plan);

// The lot with that number; numbers go on before 0 and after the last, round and round.
Lot make_lot(std::uint64_t seed, const StreetPlan& plan, int side, int number);

}  // namespace sailmap::simulate
