// The packed signature of the hardware (hls/signature_record.hpp) on the host's side.
#pragma once

#include <cstdint>
#include <span>

#include "sailmap/signature.hpp"

namespace sailmap {

// What the kernel is to be told for a configuration.
struct ChipParameters {
  std::uint16_t max_regions;
  std::uint32_t stop_ratio;
  std::uint16_t box_side;
};

// Throws Error when the hardware makes no signatures so configured (check_chip_regions).
ChipParameters chip_parameters(const RegionConfig& config);

// Of the words of a record of a frame of that size, so asked for. Throws Error when they are none: another
// length, mark, version, frame size or parameters, too many regions, a region outside the frame.
Signature signature_of_record(std::span<const std::uint32_t> words, int width, int height,
                              const ChipParameters& asked);

}  // namespace sailmap
