// What writes one call of each synthesis top: the words of its ports in and out, from the quantised
// reference.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "beats.hpp"
#include "call.hpp"
#include "sailmap/csim/frame.hpp"

namespace sailmap::testing {

// `number`: that of the frame, from 1 on.
using Writer = std::function<void(Call&, const csim::Frame&, std::size_t beat, std::uint32_t number)>;
using Writers = std::map<std::string, Writer>;  // by top

// Kernels of single stages, whatever the beat.
Writers kernel_writers();
// Whole front ends, and the signature behind one.
Writers front_end_writers();

// The streams of red, green and blue bytes, `beat` a word.
inline void components(Call& call, const csim::Frame& frame, std::size_t beat) {
  call.words("red", bytes(frame, 0, beat));
  call.words("green", bytes(frame, 1, beat));
  call.words("blue", bytes(frame, 2, beat));
}

}  // namespace sailmap::testing
