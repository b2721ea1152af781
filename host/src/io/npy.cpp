#include "sailmap/npy.hpp"

#include <bit>
#include <ostream>
#include <string>
#include <variant>

#include "sailmap/file.hpp"

namespace sailmap {

namespace {

// Samples are written as they lie in memory and declared little endian.
static_assert(std::endian::native == std::endian::little);

template <class T>
constexpr const char* type_code = nullptr;
template <>
constexpr const char* type_code<double> = "<f8";
template <>
constexpr const char* type_code<float> = "<f4";
template <>
constexpr const char* type_code<std::uint16_t> = "<u2";
template <>
constexpr const char* type_code<std::uint32_t> = "<u4";

// Magic, version 1.0, length of the rest, and a Python dictionary padded with blanks so that the samples
// begin at a multiple of 64 bytes (NumPy's format description, NEP 1).
std::string npy_header(const std::string& type, int height, int width) {
  constexpr std::size_t alignment = 64;
  constexpr std::size_t preamble = 10;
  std::string dictionary = "{'descr': '" + type + "', 'fortran_order': False, 'shape': (" +
                           std::to_string(height) + ", " + std::to_string(width) + "), }";
  const std::size_t unpadded = preamble + dictionary.size() + 1;
  dictionary.append((alignment - unpadded % alignment) % alignment, ' ');
  dictionary += '\n';
  std::string header("\x93NUMPY\x01\x00", 8);
  header += static_cast<char>(dictionary.size() & 0xFFU);
  header += static_cast<char>(dictionary.size() >> 8U);
  return header + dictionary;
}

template <class T>
void write_plane(const std::filesystem::path& path, const Plane<T>& plane) {
  write_file(path, [&plane](std::ostream& out) {
    out << npy_header(type_code<T>, plane.height(), plane.width());
    const auto bytes = std::as_bytes(plane.samples());
    const void* first = bytes.data();
    out.write(static_cast<const char*>(first), static_cast<std::streamsize>(bytes.size()));
  });
}

}  // namespace

void write_npy(const std::filesystem::path& path, const Plane<double>& plane) { write_plane(path, plane); }
void write_npy(const std::filesystem::path& path, const Plane<float>& plane) { write_plane(path, plane); }
void write_npy(const std::filesystem::path& path, const Plane<std::uint16_t>& plane) {
  write_plane(path, plane);
}
void write_npy(const std::filesystem::path& path, const Plane<std::uint32_t>& plane) {
  write_plane(path, plane);
}

void write_npy(const std::filesystem::path& path, const Map& map) {
  std::visit([&path](const auto& plane) { write_plane(path, plane); }, map.samples);
}

}  // namespace sailmap
