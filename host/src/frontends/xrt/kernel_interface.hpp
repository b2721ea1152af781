// What the host knows of the kernels between memory and memory: their names and versions, and their arguments
// in order (sailmap/hls/memory_registers.h). All that differs between them stands here.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/memory_registers.h"

namespace sailmap::fpga {

// Every buffer that a kernel may have.
enum class Buffer {
  pixels,
  intensity_maps,
  colour_maps,
  orientation_maps,
  conspicuity_maps,
  saliency,
  statistics,
  record,
  report
};
inline constexpr std::array<const char*, 9> buffer_names = {
    "pixels",     "intensity_maps", "colour_maps", "orientation_maps", "conspicuity_maps", "saliency",
    "statistics", "record",         "report"};
constexpr std::size_t buffer_count = buffer_names.size();
constexpr std::size_t index_of(Buffer buffer) { return static_cast<std::size_t>(buffer); }

// The scalars of a start. Kernels that hand out maps do not look at the last three.
struct Call {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t frame = 0;
  std::uint32_t max_regions = 0;
  std::uint32_t stop_ratio = 0;
  std::uint32_t box_side = 0;
};
inline constexpr std::array<const char*, 6> scalar_names = {"width",       "height",     "frame",
                                                            "max_regions", "stop_ratio", "box_side"};
constexpr std::array<std::uint32_t, scalar_names.size()> scalars_of(const Call& call) {
  return {call.width, call.height, call.frame, call.max_regions, call.stop_ratio, call.box_side};
}

struct KernelInterface {
  const char* name;
  std::uint32_t version;
  std::span<const Buffer> buffers;  // its first arguments; pixels first, report last
  std::size_t scalars;              // its other arguments: the first so many of a Call
  // The output whose words its report counts, and how messages call it.
  Buffer output;
  std::size_t output_bytes;  // a word
  const char* output_name;

  bool operator==(const KernelInterface& other) const { return version == other.version; }
};

inline constexpr std::array<Buffer, 8> maps_buffers = {
    Buffer::pixels,           Buffer::intensity_maps, Buffer::colour_maps, Buffer::orientation_maps,
    Buffer::conspicuity_maps, Buffer::saliency,       Buffer::statistics,  Buffer::report};
inline constexpr std::array<Buffer, 3> signature_buffers = {Buffer::pixels, Buffer::record, Buffer::report};
constexpr std::size_t maps_scalars = 3;
constexpr std::size_t signature_scalars = 6;

inline constexpr KernelInterface maps_kernel = {
    SAILMAP_MEMORY_KERNEL, SAILMAP_MEMORY_VERSION, maps_buffers, maps_scalars,
    Buffer::saliency,      SAILMAP_SALIENCY_BYTES, "maps"};
inline constexpr KernelInterface signature_kernel = {SAILMAP_SIGNATURE_KERNEL,
                                                     SAILMAP_SIGNATURE_VERSION,
                                                     signature_buffers,
                                                     signature_scalars,
                                                     Buffer::record,
                                                     4,
                                                     "a signature"};
inline constexpr std::array<KernelInterface, 2> known_kernels = {maps_kernel, signature_kernel};

// The names of a kernel's arguments, in order.
inline std::vector<std::string> argument_names(const KernelInterface& kernel) {
  std::vector<std::string> names;
  for (const Buffer buffer : kernel.buffers) names.emplace_back(buffer_names[index_of(buffer)]);
  names.insert(names.end(), scalar_names.begin(),
               scalar_names.begin() + static_cast<std::ptrdiff_t>(kernel.scalars));
  return names;
}

using BufferSizes = std::array<std::size_t, buffer_count>;  // bytes, by Buffer

// What a frame of that size fills of each buffer of a kernel; of 0 x 0, which asks for the report alone,
// that. 0 of buffers that the kernel does not have.
constexpr BufferSizes buffer_sizes(const KernelInterface& kernel, std::uint32_t width, std::uint32_t height) {
  const bool none = width == 0 || height == 0;
  const std::size_t pixels = none ? 0 : std::size_t{width} * height;
  const auto base = [](std::uint32_t side) {
    return (std::size_t{side} + hls::geometry::base_scale - 1) / hls::geometry::base_scale;
  };
  const std::size_t words = none ? 0 : base(width) * base(height);
  const BufferSizes all = {pixels * SAILMAP_PIXEL_BYTES,
                           words * SAILMAP_INTENSITY_BYTES,
                           words * SAILMAP_COLOUR_BYTES,
                           words * SAILMAP_ORIENTATION_BYTES,
                           words * SAILMAP_CONSPICUITY_BYTES,
                           words * SAILMAP_SALIENCY_BYTES,
                           none ? 0 : std::size_t{SAILMAP_STATISTICS_WORDS} * 4,
                           none ? 0 : std::size_t{SAILMAP_RECORD_WORDS} * 4,
                           std::size_t{SAILMAP_REPORT_WORDS} * 4};
  BufferSizes sizes{};
  for (const Buffer buffer : kernel.buffers) sizes[index_of(buffer)] = all[index_of(buffer)];
  return sizes;
}

}  // namespace sailmap::fpga
