// The street's surface: stretches of carriageway and pavement, and what lies behind the front line.
#pragma once

#include <cstdint>
#include <vector>

#include "lighting.hpp"
#include "raster.hpp"
#include "route.hpp"
#include "street_plan.hpp"

namespace sailmap::simulate {

class Ground {
 public:
  Ground(std::uint64_t seed, const StreetPlan& plan, double density, const cv::Mat1b& noise_plate);
  // The strips from `first` to `last` metres along the route (last - first at most its length).
  void place(double first, double last, const Lighting& lighting, std::vector<Surface>& surfaces) const;

 private:
  static constexpr int kinds = 2;     // asphalt, setts
  static constexpr int variants = 9;  // of each
  [[nodiscard]] const TexturePtr& tile(int strip) const;

  std::uint64_t seed_;
  StreetPlan plan_;
  std::vector<TexturePtr> tiles_;
  TexturePtr grass_;
};

}  // namespace sailmap::simulate
