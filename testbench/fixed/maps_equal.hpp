// All that two front ends say of one image, compared bit for bit.
#pragma once

#include <string>

#include "sailmap/maps.hpp"

namespace sailmap::testing {

inline std::string difference(const Map& got, const Map& want) {
  if (got.format != want.format) return "format " + got.format + " instead of " + want.format;
  if (got.lsb != want.lsb) return "another worth of a bit";
  if (got.width() != want.width() || got.height() != want.height()) return "another size";
  for (int y = 0; y < want.height(); ++y) {
    for (int x = 0; x < want.width(); ++x) {
      if (got.at(x, y) == want.at(x, y)) continue;
      return std::to_string(got.at(x, y) / want.lsb) + " instead of " +
             std::to_string(want.at(x, y) / want.lsb) + " at (" + std::to_string(x) + ", " +
             std::to_string(y) + ")";
    }
  }
  return got.samples == want.samples ? "" : "another type of samples";
}

inline std::string difference(const MapStatistics& got, const MapStatistics& want) {
  if (got.maximum != want.maximum) return "another maximum";
  if (got.maxima != want.maxima) {
    return "m = " + std::to_string(got.maxima) + " instead of " + std::to_string(want.maxima);
  }
  return "";
}

// Empty when all maps and statistics are equal, otherwise the first difference.
inline std::string difference(const Maps& got, const Maps& want) {
  const auto named = [](std::string_view name, const std::string& what) {
    return what.empty() ? "" : std::string(name) + ": " + what;
  };
  std::string found;
  if (got.image_width != want.image_width || got.image_height != want.image_height) return "image size";
  for (std::size_t i = 0; i < feature_count && found.empty(); ++i) {
    found = named(feature_names[i], difference(got.features[i], want.features[i]));
    if (found.empty()) {
      found = named(feature_names[i], difference(got.feature_statistics[i], want.feature_statistics[i]));
    }
  }
  for (std::size_t i = 0; i < conspicuity_count && found.empty(); ++i) {
    found = named(conspicuity_names[i], difference(got.conspicuities[i], want.conspicuities[i]));
    if (found.empty()) {
      found = named(conspicuity_names[i],
                    difference(got.conspicuity_statistics[i], want.conspicuity_statistics[i]));
    }
  }
  return found.empty() ? named("saliency", difference(got.saliency, want.saliency)) : found;
}

}  // namespace sailmap::testing
