// The FPGA as a front end, through AMD's runtime XRT: make_frontend("xrt") and what it opens.
//
// All front ends of one process share one device and keep several frames in flight on it: while one is
// computed, others are sent and fetched, as long as as many threads, each with its front end, ask for them.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "sailmap/error.hpp"
#include "sailmap/frontend.hpp"

namespace sailmap {

// The device, not the image, is at fault: there is none, it has another kernel, it does not answer, it is
// gone. It stays so: no later frame will do better.
class DeviceError : public Error {
 public:
  using Error::Error;
};

struct XrtSettings {
  // File with the kernel sailmap_memory, which hands out maps, sailmap_signature_memory, which hands out
  // signatures (SignatureMaker::chip) alone, or both (docs/fpga.md).
  std::string xclbin;
  unsigned device = 0;                      // XRT's index of the card
  std::chrono::milliseconds timeout{2000};  // for a frame, those before it included; > 0
  int frames_in_flight = 3;                 // buffer sets a kernel; 2 .. 64
  // The front end that takes over when the device fails, and for images that its kernel does not take:
  // "fixed", which computes the same bit for bit; empty: nothing, they are errors.
  std::string fallback;
  // Told once when the fallback takes over, and why; from any thread, one at a time. May be empty.
  std::function<void(const std::string&)> warn;
};

// Whether this build can drive a card: XRT was there when it was configured.
bool has_xrt();

// What make_frontend("xrt") opens from now on. Throws Error when a value is out of range or there is no such
// fallback. Without it, or with no xclbin, make_frontend("xrt") throws Error.
void set_xrt(const XrtSettings& settings);

// How many threads may wait for the device of a front end of that name while others compute: those of set_xrt
// for "xrt", 0 for others.
int waiting_threads(std::string_view frontend);

}  // namespace sailmap
