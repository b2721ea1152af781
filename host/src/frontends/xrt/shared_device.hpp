// One device for all front ends of the process: checks what the kernel says of itself, keeps several frames
// in flight, and after the first fault says the same to everyone.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "device.hpp"
#include "sailmap/maps.hpp"

namespace sailmap::fpga {

// What the kernel takes, as it reports it.
struct Limits {
  std::uint32_t max_width = 0;
  std::uint32_t max_height = 0;
  std::uint32_t beat = 1;

  [[nodiscard]] bool take(int width, int height) const;
};

class SharedDevice {
 public:
  // Asks the kernel for its report. `frames_in_flight` buffer sets, at least 1, are made when they are first
  // needed, for the kernel's largest frame, and used again and again. Throws DeviceError when the kernel does
  // not answer in time, or has another version, or limits that cannot be.
  SharedDevice(std::unique_ptr<Device> device, std::chrono::milliseconds timeout, int frames_in_flight);
  ~SharedDevice();
  SharedDevice(const SharedDevice&) = delete;
  SharedDevice& operator=(const SharedDevice&) = delete;
  SharedDevice(SharedDevice&&) = delete;
  SharedDevice& operator=(SharedDevice&&) = delete;

  [[nodiscard]] const Limits& limits() const { return limits_; }
  // The maps of an image. From any number of threads at once; waits for a free buffer set. Throws Error when
  // the kernel does not take that size, DeviceError when the device fails or has failed before.
  void compute(const ImageView& image, Maps& maps);

 private:
  void ask_for_report();
  [[nodiscard]] std::unique_ptr<Slot> acquire();
  void release(std::unique_ptr<Slot> slot);
  // The device is out of use from now on. A slot that the kernel may still write to is kept.
  void fail(const std::string& why, std::unique_ptr<Slot> slot);
  void run(Slot& slot, const Call& call) const;

  std::unique_ptr<Device> device_;
  std::chrono::milliseconds timeout_;
  Limits limits_;
  std::atomic<std::uint32_t> next_frame_ = 1;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::unique_ptr<Slot>> free_;
  int to_make_;  // slots that may still be made
  std::string failure_;
  std::vector<std::unique_ptr<Slot>> abandoned_;
};

}  // namespace sailmap::fpga
