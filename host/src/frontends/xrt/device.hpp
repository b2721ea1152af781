// A device with kernels between memory and memory, as little of it as the front end needs. Two
// implementations: XRT's (native_device.cpp) and a simulated one (simulated_device.cpp).
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "kernel_interface.hpp"
#include "sailmap/xrt.hpp"

namespace sailmap::fpga {

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

  // The host's view of a buffer that the kernel has; the same memory from frame to frame.
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
  // Those of the known kernels that it has, at least one.
  [[nodiscard]] virtual std::vector<KernelInterface> kernels() const = 0;
  // For one of them, with buffers of at least those sizes. Throws DeviceError when the device has no room.
  [[nodiscard]] virtual std::unique_ptr<Slot> make_slot(const KernelInterface& kernel,
                                                        const BufferSizes& sizes) = 0;
  // After a fault: returns when this process itself does no more work for the device.
  virtual void quiesce() {}
  // Whether closing it ends, and ends its work on slots, after a fault too.
  [[nodiscard]] virtual bool closes_after_fault() const { return false; }
};

// The device of that index with the kernels of that file, by XRT. Throws DeviceError: no XRT in this build,
// no such file, no xclbin, no such device, an xclbin for another one, no known kernel in it, or one with
// other arguments.
std::unique_ptr<Device> open_native_device(const std::string& xclbin, unsigned index);

}  // namespace sailmap::fpga
