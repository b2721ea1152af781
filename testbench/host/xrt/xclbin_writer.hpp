// A small xclbin, put together from the public container header: enough of one for XRT to open a kernel.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace sailmap::testing {

struct XclbinKernel {
  std::string name;
  std::vector<std::string> arguments;
  std::size_t buffers;  // so many of the arguments, the first; the others are scalars of 32 bits
};

// The file's bytes: one instance of each kernel.
std::string xclbin_of(const std::vector<XclbinKernel>& kernels);

}  // namespace sailmap::testing
