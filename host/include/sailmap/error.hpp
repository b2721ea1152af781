// The one exception type of the library.
#pragma once

#include <stdexcept>

namespace sailmap {

// Something from outside is wrong: the message is one line that names the input and the fault.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace sailmap
