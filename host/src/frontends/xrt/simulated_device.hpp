// A device that is not there: the C simulation of the kernels behind the buffers of a card, working on its
// own thread, with every fault a card can have.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "device.hpp"

namespace sailmap::fpga {

enum class Fault {
  none,
  no_device,
  wrong_xclbin,
  wrong_kernel,
  other_version,  // of the interface, in every report
  hang,           // frames are started and never done
  lost,           // every use of the device fails
  wrong_length,   // the report tells of an output of another length
  wrong_frame,    // the report tells of another frame: outputs mixed up
  damaged_record  // the signature is none
};

// What the kernels of the card are built for.
struct KernelLimits {
  std::uint32_t max_width = 640;
  std::uint32_t max_height = 480;
  std::uint32_t beat = 4;
};

struct Simulation {
  std::vector<KernelInterface> kernels = {maps_kernel};
  KernelLimits limits;
  Fault fault = Fault::none;
  int good_frames = 0;  // before the fault, where it is one of frames
  // The device does not begin before so many frames are started, and then takes the newest first; from then
  // on it works frame by frame. For tests: frames really are in flight at once, and who asked gets his own.
  int gather = 1;
  // Told at each start how many frames are started and not yet done.
  std::function<void(int)> on_start;
};

// "640x480x4": largest frame and pixels a beat; behind it, if wanted, which kernels the card has: "640x480x4
// maps" (as without), "640x480x4 signature" or "640x480x4 both"; and a fault as well: "640x480x4 hang 3", by
// the name above with a hyphen for each underscore, after so many good frames (none: 0), or "640x480x4 gather
// 2": Simulation::gather. Throws Error when it is no such text.
Simulation simulation_from_text(const std::string& text);

// Throws DeviceError, as open_native_device, for the faults that show here.
std::unique_ptr<Device> open_simulated_device(const Simulation& simulation);

// What a kernel does when it is started: reads and writes the buffers.
void run_kernel(const KernelInterface& kernel, Slot& slot, const Call& call, const KernelLimits& limits);

}  // namespace sailmap::fpga
