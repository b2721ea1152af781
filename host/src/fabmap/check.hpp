// Errors common to the parts of FAB-MAP.
#pragma once

#include <string>

#include "sailmap/error.hpp"
#include "sailmap/fabmap.hpp"

namespace sailmap::fabmap {

inline void check_words(const Words& words, std::size_t vocabulary) {
  int last = -1;
  for (const int word : words) {
    if (word <= last || static_cast<std::size_t>(word) >= vocabulary) {
      throw Error("fabmap: word " + std::to_string(word) + " is out of order or not one of " +
                  std::to_string(vocabulary));
    }
    last = word;
  }
}

}  // namespace sailmap::fabmap
