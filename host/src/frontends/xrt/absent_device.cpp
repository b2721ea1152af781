// Where XRT was not there when this build was configured.
#include "device.hpp"

namespace sailmap {

bool has_xrt() { return false; }

std::unique_ptr<fpga::Device> fpga::open_native_device(const std::string& /*xclbin*/, unsigned /*index*/) {
  throw DeviceError("this build has no XRT (Debian: libxrt-dev), which the front end xrt needs");
}

}  // namespace sailmap
