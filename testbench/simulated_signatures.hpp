// Signatures as of a robot on a long way, without images: for tests and benchmarks of maps of any size.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "sailmap/signature.hpp"

namespace sailmap::testing {

// The numbers are fitted to the signatures of the sequences rtabmap_corridor and gardens_point: spread of the
// descriptors' numbers over all regions and of their means over images, number of admissible pairs, and the
// distribution of similarities of images of different places.
class SimulatedWay {
 public:
  static constexpr int width = 640;
  static constexpr int height = 480;

  explicit SimulatedWay(std::uint64_t seed, int regions = 20) : random_(seed), regions_(regions) {
    for (double& value : surroundings_) value = normal();
  }

  // The next image on the way: most regions of the last one, a little further on, and some new ones.
  Signature next() {
    constexpr double persistence = 0.97;
    for (double& value : surroundings_) {
      value = persistence * value + std::sqrt(1 - persistence * persistence) * normal();
    }
    last_ = moved(last_, 24, 0.15, 0.35);
    return last_;
  }

  // Another image of the same place: another viewpoint and other light.
  Signature revisited(const Signature& place) { return moved(place, 16, 0.1, 0.25); }

 private:
  double normal() { return std::normal_distribution<double>()(random_); }
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }

  static std::int16_t on_grid(double position, int side) {
    return static_cast<std::int16_t>(4 * std::clamp(static_cast<int>(position / 4), 0, side / 4 - 1));
  }

  // Shares that sum to one, from as many numbers of any size, as a kind of feature maps has.
  static void set_shares(Descriptor& v, const std::array<double, feature_count>& numbers) {
    std::array<double, conspicuity_count> sums{};
    for (std::size_t i = 0; i < feature_count; ++i) sums[kind_of_feature[i]] += std::exp(numbers[i]);
    for (std::size_t i = 0; i < feature_count; ++i) {
      v[i] = static_cast<float>(std::exp(numbers[i]) / sums[kind_of_feature[i]]);
    }
  }

  // Some things look alike wherever they stand (sky, ground, walls): a region shows one of a few such sorts,
  // the same for every way, coloured by its surroundings.
  Region new_region() {
    constexpr int sorts = 10;
    constexpr std::array<double, conspicuity_count> of_sort = {0.7, 1.5, 0.35};
    constexpr std::array<double, conspicuity_count> of_image = {0.35, 0.5, 0.15};
    constexpr std::array<double, conspicuity_count> of_region = {0.55, 0.75, 0.25};
    Region region;
    const double spread = std::exp(0.3 * surroundings_[8]);
    region.x = on_grid(width * (0.5 + 0.12 * surroundings_[7] + 0.23 * spread * normal()), width);
    region.y = on_grid(height * (0.41 + 0.1 * surroundings_[6] + 0.18 * spread * normal()), height);
    // What is above is of another sort than what is below, and left than right; how much so is up to the
    // surroundings.
    const double variety = std::exp(0.7 * surroundings_[9] - 0.2);
    const double sort = 0.5 * surroundings_[0] + 0.6 * (region.y / 120.0 - 1.6) +
                        0.5 * surroundings_[5] * (region.x / 160.0 - 2) + 0.3 * variety * normal();
    const auto number = static_cast<std::uint64_t>(std::clamp((sort + 2) / 4 * sorts, 0.0, sorts - 1.0));
    std::mt19937_64 look(number);
    std::array<double, feature_count> numbers{};
    for (std::size_t i = 0; i < feature_count; ++i) {
      const std::size_t kind = kind_of_feature[i];
      numbers[i] = of_sort[kind] * std::normal_distribution<double>()(look) +
                   of_image[kind] * surroundings_[i] + variety * of_region[kind] * normal();
    }
    region.saliency = static_cast<float>(uniform(0.5, 2));
    set_shares(region.descriptor, numbers);
    return region;
  }

  // The place seen from `pixels` (standard deviation) further, each region for itself by a quarter of that;
  // descriptors changed by `noise` (of their logarithms), a part of the regions replaced.
  Signature moved(const Signature& place, double pixels, double noise, double replaced) {
    Signature out{width, height, {}};
    const double dx = pixels * normal();
    const double dy = pixels / 3 * normal();
    for (const Region& from : place.regions) {
      if (uniform(0, 1) < replaced) continue;
      Region to = from;
      to.x = on_grid(from.x + dx + pixels / 4 * normal(), width);
      to.y = on_grid(from.y + dy + pixels / 4 * normal(), height);
      std::array<double, feature_count> numbers{};
      for (std::size_t i = 0; i < feature_count; ++i) {
        numbers[i] = std::log(std::max(from.descriptor[i], 1e-4F)) + noise * normal();
      }
      set_shares(to.descriptor, numbers);
      out.regions.push_back(to);
    }
    while (static_cast<int>(out.regions.size()) < regions_) out.regions.push_back(new_region());
    std::sort(out.regions.begin(), out.regions.end(),
              [](const Region& a, const Region& b) { return a.saliency > b.saliency; });
    return out;
  }

  std::mt19937_64 random_;
  int regions_;
  std::array<double, feature_count> surroundings_{};
  Signature last_;
};

}  // namespace sailmap::testing
