// Arrays in NumPy's .npy format, version 1.0, little endian, C order.
#pragma once

#include <cstdint>
#include <filesystem>

#include "sailmap/maps.hpp"
#include "sailmap/ref/plane.hpp"

namespace sailmap {

// Shape (height, width); the file is replaced whole or not at all. Throws Error when it cannot be written.
void write_npy(const std::filesystem::path& path, const Plane<double>& plane);
void write_npy(const std::filesystem::path& path, const Plane<float>& plane);
void write_npy(const std::filesystem::path& path, const Plane<std::uint16_t>& plane);
void write_npy(const std::filesystem::path& path, const Plane<std::uint32_t>& plane);
// The map's own samples: doubles of the reference, raw integers of the fixed-point front ends.
void write_npy(const std::filesystem::path& path, const Map& map);

}  // namespace sailmap
