// Tells the address sanitizer when the program goes on on another stack; without it, nothing.
#pragma once

#include <cstddef>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/common_interface_defs.h>
#endif

namespace sailmap::csim {

// A stack: its lowest address and its size.
struct StackBounds {
  const void* bottom = nullptr;
  std::size_t size = 0;
};

// About to leave for stack `to`; `kept` is what the sanitizer wants back on return, nullptr when there is
// none.
inline void leave_for([[maybe_unused]] const StackBounds& to, [[maybe_unused]] void** kept) {
#ifdef __SANITIZE_ADDRESS__
  __sanitizer_start_switch_fiber(kept, to.bottom, to.size);
#endif
}

// Arrived, with what was kept when this stack was left; returns the stack come from.
inline StackBounds arrived([[maybe_unused]] void* kept) {
  StackBounds from;
#ifdef __SANITIZE_ADDRESS__
  __sanitizer_finish_switch_fiber(kept, &from.bottom, &from.size);
#endif
  return from;
}

}  // namespace sailmap::csim
