// The whole reference front end, spec sections 2-7: image in, ten feature maps, three conspicuities, saliency
// out.
#pragma once

#include <array>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sailmap/hls/geometry.hpp"
#include "sailmap/ref/across_scales.hpp"
#include "sailmap/ref/centre_surround.hpp"
#include "sailmap/ref/channels.hpp"
#include "sailmap/ref/normalise.hpp"
#include "sailmap/ref/orientation.hpp"
#include "sailmap/ref/plane.hpp"
#include "sailmap/ref/policy.hpp"
#include "sailmap/ref/pyramid.hpp"
#include "sailmap/ref/saliency.hpp"

namespace sailmap::ref {

// All maps have base-level size, ceil(W/4) x ceil(H/4).
struct Model {
  // In the order of spec section 6: intensity_on, intensity_off, green, blue, red, yellow, ori_0 ... ori_135.
  std::array<Plane<double>, hls::geometry::feature_maps> features;
  std::array<MapStatistics, hls::geometry::feature_maps> feature_statistics;
  // Intensity, colour, orientation, before their own normalisation.
  std::array<Plane<double>, hls::geometry::conspicuity_maps> conspicuities;
  std::array<MapStatistics, hls::geometry::conspicuity_maps> conspicuity_statistics;
  Plane<double> saliency;
};

using Pyramid = std::vector<Plane<double>>;

using LevelMaps = std::array<Plane<double>, hls::geometry::map_levels>;

// `at_level(plane)` on each pyramid level that carries maps, finest first.
template <class AtLevel>
auto each_level(const Pyramid& pyramid, AtLevel at_level) {
  using namespace hls::geometry;
  std::array<decltype(at_level(pyramid[0])), map_levels> maps;
  for (int level = base_level; level <= top_level; ++level) {
    maps[static_cast<std::size_t>(level - base_level)] = at_level(pyramid[static_cast<std::size_t>(level)]);
  }
  return maps;
}

// The two intensity maps share their contrasts: sections 4 and 6.
template <class Policy>
std::array<Plane<double>, 2> intensity_sums(const Pyramid& intensity) {
  auto contrasts = each_level(intensity, centre_surround<Policy, point::intensity_contrast>);
  LevelMaps on;
  LevelMaps off;
  for (std::size_t level = 0; level < contrasts.size(); ++level) {
    on[level] = std::move(contrasts[level].on);
    off[level] = std::move(contrasts[level].off);
  }
  return {across_scales<Policy, point::intensity_partial, point::intensity_sum>(on),
          across_scales<Policy, point::intensity_partial, point::intensity_sum>(off)};
}

template <class Policy>
Plane<double> colour_sum(Plane<double> channel) {
  const Pyramid levels = pyramid<Policy, point::colour>(std::move(channel));
  return across_scales<Policy, point::colour_partial, point::colour_sum>(each_level(
      levels,
      [](const Plane<double>& level) { return centre_surround<Policy, point::colour_contrast>(level).on; }));
}

template <class Policy>
Plane<double> orientation_sum(const Pyramid& intensity, int index) {
  return across_scales<Policy, point::orientation_partial, point::orientation_sum>(each_level(
      intensity, [index](const Plane<double>& level) { return gabor_energy<Policy>(level, index); }));
}

// Sections 2-6: the feature maps before they are rounded for the store.
template <class Policy>
std::array<Plane<double>, hls::geometry::feature_maps> feature_sums(const ImageView& image) {
  Channels c = channels<Policy>(image);
  const Pyramid intensity = pyramid<Policy, point::intensity>(std::move(c.intensity));
  auto [on, off] = intensity_sums<Policy>(intensity);
  return {std::move(on),
          std::move(off),
          colour_sum<Policy>(std::move(c.green)),
          colour_sum<Policy>(std::move(c.blue)),
          colour_sum<Policy>(std::move(c.red)),
          colour_sum<Policy>(std::move(c.yellow)),
          orientation_sum<Policy>(intensity, 0),
          orientation_sum<Policy>(intensity, 1),
          orientation_sum<Policy>(intensity, 2),
          orientation_sum<Policy>(intensity, 3)};
}

// Section 7 of the maps of one kind, [first, first + Count): they are stored with their statistics and
// normalised, and the sum is the kind's conspicuity with its own.
template <class Policy, class Feature, class Sum, class Conspicuity, std::size_t First, std::size_t Count>
void normalise_kind(const std::array<Plane<double>, hls::geometry::feature_maps>& sums, std::size_t kind,
                    Model& out) {
  std::array<Plane<double>, Count> normalised;
  for (std::size_t i = 0; i < Count; ++i) {
    Plane<double>& map = out.features[First + i];
    MapStatistics& stats = out.feature_statistics[First + i];
    map = stored<Policy, Feature>(sums[First + i]);
    stats = statistics(sums[First + i], map, Policy::tie);
    normalised[i] = normalise<Policy, point::normalised>(map, stats);
  }
  const Plane<double> sum = conspicuity<Policy, Sum>(normalised);
  out.conspicuities[kind] = stored<Policy, Conspicuity>(sum);
  out.conspicuity_statistics[kind] = statistics(sum, out.conspicuities[kind], Policy::tie);
}

// Throws std::invalid_argument when a side is outside 64..4096 pixels (spec section 1).
template <class Policy>
Model compute(const ImageView& image) {
  using namespace hls::geometry;
  if (!valid_side(image.width) || !valid_side(image.height)) {
    throw std::invalid_argument("image sides must be 64 to 4096 pixels");
  }
  Model out;
  const auto sums = feature_sums<Policy>(image);
  normalise_kind<Policy, point::intensity_feature, point::intensity_conspicuity_sum,
                 point::intensity_conspicuity, 0, intensity_maps>(sums, 0, out);
  normalise_kind<Policy, point::colour_feature, point::colour_conspicuity_sum, point::colour_conspicuity,
                 intensity_maps, colour_maps>(sums, 1, out);
  normalise_kind<Policy, point::orientation_feature, point::orientation_conspicuity_sum,
                 point::orientation_conspicuity, intensity_maps + colour_maps, orientation_maps>(sums, 2,
                                                                                                 out);
  out.saliency = saliency<Policy>(out.conspicuities, out.conspicuity_statistics);
  return out;
}

}  // namespace sailmap::ref
