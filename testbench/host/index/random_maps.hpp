// Random maps of all sorts of signatures, odd ones among them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "host/index/exhaustive.hpp"
#include "simulated_signatures.hpp"

namespace sailmap::testing {

// Everything follows from the seed.
class RandomMaps {
 public:
  explicit RandomMaps(std::uint64_t seed) : random_(seed) {
    width_ = pick({300, 640, 960, 1920, 4096, 64});
    height_ = pick({400, 480, 540, 1080, 4096, 64});
    usual_regions_ = pick({3, 8, 20, 20, 33});
    odd_ = pick({0, 0, 1, 2});
    one_sort_ = chance(0.5);
  }

  // Views are added in the order of `order`, nodes by their first views.
  struct Map {
    std::vector<Views> nodes;
    std::vector<PlaceIndex::Entry> order;
  };

  Map map(int views, bool sparse) {
    Map out;
    for (int i = 0; i < views; ++i) {
      const bool joins = sparse && !out.nodes.empty() && chance(0.5);
      const int node = joins ? below(static_cast<int>(out.nodes.size())) : static_cast<int>(out.nodes.size());
      const Signature signature = another(out);
      if (!joins) out.nodes.emplace_back();
      Views& of_node = out.nodes[static_cast<std::size_t>(node)];
      out.order.push_back({node, static_cast<int>(of_node.size())});
      of_node.push_back(signature);
    }
    return out;
  }

  // New, or like one of the map, or one of the map.
  Signature another(const Map& map) {
    if (map.nodes.empty() || chance(0.5)) return signature();
    const Views& views = map.nodes[static_cast<std::size_t>(below(static_cast<int>(map.nodes.size())))];
    const Signature& of_map = views[static_cast<std::size_t>(below(static_cast<int>(views.size())))];
    return chance(0.3) ? of_map : perturbed(of_map);
  }

  MatchConfig config() {
    MatchConfig out;
    out.method = pick({Method::paper, Method::paper_weighted});
    out.search_radius = pick({0.15, 0.15, 0.15, 1e-6, 0.01, 0.5, 1.1, 1e9});
    out.displacement_tolerance = pick({0.08, 0.08, 0.0, 0.01, 0.4, 1e9});
    out.similarity_cap = pick({1e6, 1e6, 5.0, 0.5, std::numeric_limits<double>::infinity()});
    return out;
  }

  double at_least() {
    return pick({0.0, 0.0, 0.5, 2.0, 5.0, 20.0, 1e6, std::numeric_limits<double>::infinity()});
  }
  int same_place_nodes() { return pick({5, 5, 0, 1, 30, -1, 100000}); }
  int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(random_); }
  bool chance(double part) { return std::bernoulli_distribution(part)(random_); }

 private:
  template <class T>
  T pick(std::initializer_list<T> values) {
    return *(values.begin() + below(static_cast<int>(values.size())));
  }
  float uniform(float from, float to) { return std::uniform_real_distribution<float>(from, to)(random_); }

  Signature signature() {
    Signature out{width_, height_, {}};
    const int count = odd_ > 0 && chance(0.2) ? below(45) : usual_regions_;
    for (int i = 0; i < count; ++i) out.regions.push_back(region());
    return out;
  }

  Region region() {
    Region out;
    const int grid = one_sort_ || chance(0.9) ? 4 : 1;
    out.x = static_cast<std::int16_t>(below(width_ / grid) * grid);
    out.y = static_cast<std::int16_t>(below(height_ / grid) * grid);
    out.saliency = uniform(0, 1);
    for (float& value : out.descriptor) value = number();
    if (odd_ == 0 || chance(0.8)) make_shares(out.descriptor);
    return out;
  }

  float number() {
    if (odd_ < 2 || chance(0.995)) return std::max(0.0F, uniform(-0.3F, 1));
    return pick({0.0F, 1e-30F, 1e-20F, -3.0F, 700.0F, 2000.0F, 1e13F, 1e20F, 3e38F,
                 std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()});
  }

  static void make_shares(Descriptor& v) {
    std::array<float, conspicuity_count> sums{};
    for (std::size_t i = 0; i < feature_count; ++i) sums[kind_of_feature[i]] += v[i];
    for (std::size_t i = 0; i < feature_count; ++i) {
      const float sum = sums[kind_of_feature[i]];
      if (sum > 0 && std::isfinite(sum)) v[i] /= sum;
    }
  }

  Signature perturbed(Signature out) {
    const float noise = pick({0.0F, 1e-7F, 1e-3F, 0.05F});
    const int pixels = pick({0, 4, 12, 60});
    for (Region& region : out.regions) {
      if (chance(0.15)) region = this->region();
      const auto moved = [&](int at, int side) {
        return static_cast<std::int16_t>(
            std::clamp(at + (below(2 * pixels + 1) - pixels) / 4 * 4, 0, side - 1));
      };
      region.x = moved(region.x, width_);
      region.y = moved(region.y, height_);
      for (float& value : region.descriptor) value += uniform(-noise, noise);
    }
    std::shuffle(out.regions.begin(), out.regions.end(), random_);
    return out;
  }

  std::mt19937_64 random_;
  int width_, height_;
  int usual_regions_;
  int odd_;  // 0: nothing odd; 1: numbers of regions, and numbers that are no shares; 2: extreme numbers
  bool one_sort_;  // all positions on the grid of base-level pixels
};

}  // namespace sailmap::testing
