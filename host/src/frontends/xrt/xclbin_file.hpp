// A look at an xclbin before XRT reads it, which trusts the lengths in it.
#pragma once

#include <string>

namespace sailmap::fpga {

// Throws DeviceError when there is no such file, it is no xclbin, or it is cut off.
void check_xclbin(const std::string& path);

}  // namespace sailmap::fpga
