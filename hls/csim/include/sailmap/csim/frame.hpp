// What goes into the simulated front end and what comes out.
#pragma once

#include <cstdint>
#include <vector>

namespace sailmap::csim {

// 8-bit pixels in raster order, red, green and blue interleaved.
struct Frame {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

// The outputs of hls::FrontEnd for one frame, lanes still packed.
struct FrontEndWords {
  std::vector<std::uint32_t> intensity_maps;
  std::vector<std::uint64_t> colour_maps;
  std::vector<std::uint64_t> orientation_maps;
  std::vector<std::uint64_t> conspicuity_maps;
  std::vector<std::uint16_t> saliency;
  std::vector<std::uint32_t> statistics;

  bool operator==(const FrontEndWords&) const = default;
};

}  // namespace sailmap::csim
