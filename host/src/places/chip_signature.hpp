// Signatures as the hardware makes them (hls/signature.hpp), computed here.
#pragma once

#include "sailmap/maps.hpp"
#include "sailmap/signature.hpp"

namespace sailmap {

// Equal to the kernel's bit for bit. Throws Error when the hardware makes no such signatures
// (check_chip_regions), or the maps are not raw integers.
Signature chip_signature(const Maps& maps, const RegionConfig& config);

}  // namespace sailmap
