// Houses and gardens along both sides of the street.
#pragma once

#include <cstdint>
#include <vector>

#include "lot.hpp"
#include "scene.hpp"
#include "street_plan.hpp"
#include "texture_cache.hpp"

namespace sailmap::simulate {

class Buildings {
 public:
  // `photographs`: BGR images that take the place of drawn fronts; empty: all are drawn.
  Buildings(std::uint64_t seed, const StreetPlan& plan, double density, const cv::Mat1b& noise_plate,
            std::vector<cv::Mat> photographs);

  // Those from `first` to `last` metres along the route (last - first at most its length).
  void place(double first, double last, const Moment& moment, const Sprites& sprites, Scene& scene) const;

 private:
  struct Footprint;
  [[nodiscard]] Footprint measure(const Lot& lot) const;
  [[nodiscard]] TexturePtr facade(const Lot& lot, double width, double rise) const;
  [[nodiscard]] cv::Mat4b photograph(const Lot& lot, double width, double height) const;
  void place_front(const Lot& lot, const Footprint& at, const Moment& moment, Scene& scene) const;
  void place_sides(const Lot& lot, const Footprint& at, const Moment& moment, Scene& scene) const;
  void place_roof(const Lot& lot, const Footprint& at, const Moment& moment, Scene& scene) const;
  void place_hanging_sign(const Lot& lot, const Footprint& at, const Moment& moment, Scene& scene) const;
  void place_garden(const Lot& lot, const Footprint& at, const Moment& moment, const Sprites& sprites,
                    Scene& scene) const;

  std::uint64_t seed_;
  StreetPlan plan_;
  double density_;
  cv::Mat1b noise_plate_;
  std::vector<cv::Mat> photographs_;
  std::vector<TexturePtr> side_walls_, roofs_, signs_, fences_;
  mutable TextureCache facades_;
};

}  // namespace sailmap::simulate
