// The one exception type of the library.
#pragma once

#include <stdexcept>
#include <string>

namespace sailmap {

// Something from outside is wrong: the message is one line that names the input and the fault.
class Error : public std::runtime_error {
 public:
  // What a message quotes may hold anything: each control character in it, line ends too, becomes a '?'.
  explicit Error(const std::string& message);
};

}  // namespace sailmap
