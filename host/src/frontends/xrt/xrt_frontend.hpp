// The front end `xrt`: a device that all its objects share, and what takes over from it.
#pragma once

#include <functional>
#include <memory>

#include "device.hpp"
#include "sailmap/xrt.hpp"

namespace sailmap::fpga {

using Opener = std::function<std::unique_ptr<Device>()>;

class XrtService;

// Opens the device at once. Throws DeviceError when that fails and the settings name no fallback.
std::shared_ptr<XrtService> make_service(const XrtSettings& settings, const Opener& open);

// A front end on that device; any number of them, each for one thread at a time.
std::unique_ptr<Frontend> make_frontend_on(std::shared_ptr<XrtService> service);

}  // namespace sailmap::fpga
