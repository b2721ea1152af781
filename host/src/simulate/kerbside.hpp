// What stands along the kerbs, goes about on the pavements and drives on the street.
#pragma once

#include <cstdint>
#include <vector>

#include "car.hpp"
#include "scene.hpp"
#include "street_plan.hpp"

namespace sailmap::simulate {

class Kerbside {
 public:
  // `moving_objects`: people and vehicles on each hundred metres, on average; also how often parked cars
  // change.
  Kerbside(std::uint64_t seed, const StreetPlan& plan, int moving_objects);

  // Those from `first` to `last` metres along the route (last - first at most its length; first may be below
  // 0).
  void place(double first, double last, const Moment& moment, const Sprites& sprites, Scene& scene) const;

 private:
  void place_furniture(double first, double last, const Moment& moment, const Sprites& sprites,
                       Scene& scene) const;
  void place_parked_cars(double first, double last, const Moment& moment, const Sprites& sprites,
                         Scene& scene) const;
  void place_traffic(double first, double last, const Moment& moment, const Sprites& sprites,
                     Scene& scene) const;
  void place_car(std::uint64_t which, double along, double lateral, bool oncoming, const Moment& moment,
                 const Sprites& sprites, Scene& scene) const;

  std::uint64_t seed_;
  StreetPlan plan_;
  int moving_objects_;
  std::vector<CarModel> cars_;
};

}  // namespace sailmap::simulate
