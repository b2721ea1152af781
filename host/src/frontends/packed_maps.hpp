// The words that the hardware puts out become Maps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "fixed_maps.hpp"
#include "sailmap/hls/geometry.hpp"

namespace sailmap {

// The outputs of hls::FrontEnd for one frame, lanes still packed.
struct PackedMaps {
  std::span<const std::uint32_t> intensity_maps;
  std::span<const std::uint64_t> colour_maps;
  std::span<const std::uint64_t> orientation_maps;
  std::span<const std::uint64_t> conspicuity_maps;
  std::span<const std::uint16_t> saliency;
  std::span<const std::uint32_t> statistics;
};

// Fills `maps` for an image of that size; every span must have the words of it.
void unpack(const PackedMaps& words, int image_width, int image_height, Maps& maps);

}  // namespace sailmap
