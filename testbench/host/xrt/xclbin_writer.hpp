// A small xclbin, put together from the public container header: enough of one for XRT to open a kernel.
#pragma once

#include <string>
#include <vector>

namespace sailmap::testing {

// The file's bytes: one instance of a kernel of that name, the first eight of its arguments buffers, the
// others scalars of 32 bits.
std::string xclbin_of(const std::string& kernel, const std::vector<std::string>& arguments);

}  // namespace sailmap::testing
