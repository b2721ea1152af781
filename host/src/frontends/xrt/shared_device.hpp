// One device for all front ends of the process: checks what its kernels say of themselves, keeps several
// frames in flight, and after the first fault says the same to everyone.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "device.hpp"
#include "frontends/signature_record.hpp"
#include "sailmap/maps.hpp"
#include "sailmap/signature.hpp"

namespace sailmap::fpga {

// What a kernel takes, as it reports it.
struct Limits {
  std::uint32_t max_width = 0;
  std::uint32_t max_height = 0;
  std::uint32_t beat = 1;

  [[nodiscard]] bool take(int width, int height) const;
};

class SharedDevice {
 public:
  // Asks the kernels for their reports. `frames_in_flight` buffer sets a kernel, at least 1, are made when
  // they are first needed, for the kernel's largest frame, and used again and again. Throws DeviceError when
  // a kernel does not answer in time, or has another version, or limits that cannot be.
  SharedDevice(std::unique_ptr<Device> device, std::chrono::milliseconds timeout, int frames_in_flight);
  ~SharedDevice();
  SharedDevice(const SharedDevice&) = delete;
  SharedDevice& operator=(const SharedDevice&) = delete;
  SharedDevice(SharedDevice&&) = delete;
  SharedDevice& operator=(SharedDevice&&) = delete;

  // Whether it has a kernel that hands out maps, or signatures.
  [[nodiscard]] bool has(const KernelInterface& kernel) const;
  // The maps of an image. From any number of threads at once; waits for a free buffer set. Throws Error when
  // the kernel does not take that size, DeviceError when the device fails or has failed before, or has no
  // such kernel.
  void compute(const ImageView& image, Maps& maps);
  // The same for the signature that is asked for; a damaged one is a DeviceError.
  void describe(const ImageView& image, const ChipParameters& asked, Signature& signature);

 private:
  // A kernel of the device, and the buffer sets for it.
  struct Kernel {
    KernelInterface interface;
    int to_make;  // slots that may still be made
    Limits limits{};
    std::vector<std::unique_ptr<Slot>> free{};
  };

  void ask_for_report(Kernel& kernel);
  [[nodiscard]] Kernel& demand(const KernelInterface& interface);
  // Has the kernel work on an image; `take` reads what it wrote.
  template <class Take>
  void work(Kernel& kernel, const ImageView& image, const ChipParameters& asked, Take take);
  [[nodiscard]] std::unique_ptr<Slot> acquire(Kernel& kernel);
  void release(Kernel& kernel, std::unique_ptr<Slot> slot);
  // The device is out of use from now on. A slot that the kernel may still write to is kept.
  void fail(const std::string& why, std::unique_ptr<Slot> slot);
  void run(const KernelInterface& interface, Slot& slot, const Call& call) const;

  std::unique_ptr<Device> device_;
  std::chrono::milliseconds timeout_;
  std::atomic<std::uint32_t> next_frame_ = 1;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Kernel> kernels_;  // which, and their limits, stay as they are made
  std::string failure_;
  std::vector<std::unique_ptr<Slot>> abandoned_;
};

}  // namespace sailmap::fpga
