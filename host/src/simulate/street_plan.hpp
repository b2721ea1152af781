// Measures of the street that its parts share.
#pragma once

#include <algorithm>
#include <cmath>

#include "route.hpp"

namespace sailmap::simulate {

struct StreetPlan {
  const Route* route = nullptr;
  double front = 8;  // metres from the middle of the street to the fronts of the buildings
  double kerb = 5;   // to the edge of the pavement
  bool wide = true;  // room for parked cars and oncoming vehicles
};

// Metres from the middle to the fronts in a circuit of that length: a lane in a small one.
inline double front_distance(double circuit) { return std::clamp(circuit / 15, 3.6, 8.0); }

inline StreetPlan plan_street(const Route& route) {
  const double front = front_distance(route.length());
  return {&route, front, 0.62 * front, front > 5.5};
}

// How far behind the fronts things may stand without meeting those of the bend's other side.
inline double room_behind(const StreetPlan& plan, double curvature, int side, double wanted) {
  const double towards = curvature * side;  // positive on the inner side
  if (towards <= 0) return wanted;
  return std::clamp(0.75 / towards - plan.front, 0.3, wanted);
}

}  // namespace sailmap::simulate
