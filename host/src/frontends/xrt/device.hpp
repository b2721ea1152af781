// A device with the kernel sailmap_memory, as little of it as the front end needs. Two implementations: XRT's
// (native_device.cpp) and a simulated one (simulated_device.cpp).
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/memory_registers.h"
#include "sailmap/xrt.hpp"

namespace sailmap::fpga {

// The kernel's buffers, in the order of its arguments.
enum class Buffer {
  pixels,
  intensity_maps,
  colour_maps,
  orientation_maps,
  conspicuity_maps,
  saliency,
  statistics,
  report
};
constexpr std::size_t buffer_count = 8;
constexpr std::size_t index_of(Buffer buffer) { return static_cast<std::size_t>(buffer); }
// Its other arguments come behind: width, height, frame.
constexpr std::array<const char*, buffer_count + 3> argument_names = {"pixels",
                                                                      "intensity_maps",
                                                                      "colour_maps",
                                                                      "orientation_maps",
                                                                      "conspicuity_maps",
                                                                      "saliency",
                                                                      "statistics",
                                                                      "report",
                                                                      "width",
                                                                      "height",
                                                                      "frame"};

using BufferSizes = std::array<std::size_t, buffer_count>;  // bytes

// What a frame of that size fills of each buffer; of 0 x 0, which asks for the report alone, that.
constexpr BufferSizes buffer_sizes(std::uint32_t width, std::uint32_t height) {
  const bool none = width == 0 || height == 0;
  const std::size_t pixels = none ? 0 : std::size_t{width} * height;
  const auto base = [](std::uint32_t side) {
    return (std::size_t{side} + hls::geometry::base_scale - 1) / hls::geometry::base_scale;
  };
  const std::size_t words = none ? 0 : base(width) * base(height);
  return {pixels * SAILMAP_PIXEL_BYTES,
          words * SAILMAP_INTENSITY_BYTES,
          words * SAILMAP_COLOUR_BYTES,
          words * SAILMAP_ORIENTATION_BYTES,
          words * SAILMAP_CONSPICUITY_BYTES,
          words * SAILMAP_SALIENCY_BYTES,
          none ? 0 : std::size_t{SAILMAP_STATISTICS_WORDS} * 4,
          std::size_t{SAILMAP_REPORT_WORDS} * 4};
}

// The scalars of a start.
struct Call {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t frame = 0;
};

enum class Outcome { done, timeout };

// Buffers for one frame and the run of the kernel that uses them. One thread at a time uses a slot; several
// slots of a device may run at once. Every function throws DeviceError when the device is gone or refuses.
class Slot {
 public:
  Slot() = default;
  virtual ~Slot() = default;
  Slot(const Slot&) = delete;
  Slot& operator=(const Slot&) = delete;
  Slot(Slot&&) = delete;
  Slot& operator=(Slot&&) = delete;

  // The host's view of a buffer; the same memory from frame to frame.
  [[nodiscard]] virtual std::span<std::byte> memory(Buffer buffer) = 0;
  // Sends the pixels and starts the kernel behind the frames started before; does not wait for it.
  virtual void start(const Call& call) = 0;
  // Waits for the frame that start began and fetches what it wrote. After a timeout the kernel may still
  // write: the slot must neither be used again nor destroyed.
  [[nodiscard]] virtual Outcome wait(std::chrono::milliseconds timeout) = 0;

  template <class Word>
  [[nodiscard]] std::span<Word> words(Buffer buffer, std::size_t bytes) {
    return {reinterpret_cast<Word*>(memory(buffer).data()), bytes / sizeof(Word)};
  }
};

class Device {
 public:
  Device() = default;
  virtual ~Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  Device(Device&&) = delete;
  Device& operator=(Device&&) = delete;

  // As messages call it: "device 0".
  [[nodiscard]] virtual std::string name() const = 0;
  // With buffers of at least those sizes. Throws DeviceError when the device has no room for them.
  [[nodiscard]] virtual std::unique_ptr<Slot> make_slot(const BufferSizes& sizes) = 0;
  // After a fault: returns when this process itself does no more work for the device.
  virtual void quiesce() {}
  // Whether closing it ends, and ends its work on slots, after a fault too.
  [[nodiscard]] virtual bool closes_after_fault() const { return false; }
};

// The device of that index with the kernel of that file, by XRT. Throws DeviceError: no XRT in this build, no
// such file, no xclbin, no such device, an xclbin for another one, no kernel sailmap_memory in it, or one
// with other arguments.
std::unique_ptr<Device> open_native_device(const std::string& xclbin, unsigned index);

}  // namespace sailmap::fpga
