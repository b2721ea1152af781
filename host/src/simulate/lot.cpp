#include "lot.hpp"

#include <algorithm>
#include <cmath>

#include "random.hpp"

namespace sailmap::simulate {
namespace {

constexpr double lot_length = 10;  // metres, about

// Most houses are an architect's own; some belong to a terrace of their neighbours, some to a chain that
// builds the same house, sign and all, everywhere: those places look alike.
void choose_architect(std::uint64_t seed, Random& random, Lot& lot) {
  constexpr int terrace = 4;  // houses
  constexpr int chains = 5;
  lot.style = random.next();
  lot.detail = random.next();
  const std::uint64_t row = hash(seed, Subject::style, lot.side, lot.index / terrace);
  if (unit(row) < 0.22) {
    lot.style = mix(row);
  } else if (random.chance(0.1)) {
    const int chain = random.index(chains);
    lot.style = hash(seed, Subject::style, 0, chain);
    lot.detail = hash(seed, Subject::detail, 0, chain);
  }
}

void choose_shape(const StreetPlan& plan, Lot& lot) {
  Random random(hash(lot.style, Subject::lot));
  int storeys = 1 + random.index(plan.wide ? 4 : 3);
  if (random.chance(0.07)) storeys += 3;
  lot.eaves = 3.6 + storeys * random.uniform(2.8, 3.3);
  const int roof = random.index(8);
  if (roof < 3) {
    lot.roof = RoofShape::pitched;
    lot.rise = random.uniform(2, 3.6);
  } else if (roof < 5 && storeys < 5) {
    lot.roof = roof == 3 ? RoofShape::gable : RoofShape::stepped;
    lot.rise = random.uniform(2.5, 4.5);
  } else {
    lot.roof = RoofShape::flat;
    lot.rise = 0;
  }
}

}  // namespace

int lot_count(const StreetPlan& plan) {
  return std::max(6, static_cast<int>(std::lround(plan.route->length() / lot_length)));
}

Lot make_lot(std::uint64_t seed, const StreetPlan& plan, int side, int number) {
  const int count = lot_count(plan);
  const double pitch = plan.route->length() / count;
  const auto boundary = [&](int n) {
    const int wrapped = ((n % count) + count) % count;
    return pitch * (n + 0.5 * (unit(hash(seed, Subject::lot, side, wrapped)) - 0.5));
  };
  Lot lot;
  lot.side = side;
  lot.index = ((number % count) + count) % count;
  lot.first = boundary(number);
  lot.last = boundary(number + 1);
  Random random(hash(seed, Subject::lot, side, lot.index, 1));
  lot.garden = random.chance(0.13);
  lot.fence = static_cast<Fence>(random.index(3));
  lot.setback = random.chance(0.3) ? random.uniform(0.3, 1.4) : 0;
  choose_architect(seed, random, lot);
  choose_shape(plan, lot);
  return lot;
}

}  // namespace sailmap::simulate
