// The front end in C simulation, compiled for frames of any size: frames in, everything the hardware puts out
// as raw words.
#pragma once

#include <span>
#include <vector>

#include "sailmap/csim/frame.hpp"
#include "sailmap/csim/scheduler.hpp"

namespace sailmap::csim {

// The most pixels a beat that a width is a multiple of.
constexpr int widest_beat(int width) {
  return width % 8 == 0 ? 8 : width % 4 == 0 ? 4 : width % 2 == 0 ? 2 : 1;
}

// Frames of 64 to 4096 pixels a side back to back through one network with `beat` pixels a beat. The kernels
// keep state in statics, as hardware does, so calls take turns, whatever thread they come from. Throws
// std::invalid_argument when the front end does not take a frame, or there is no such beat; NetworkError when
// the network is wrong.
std::vector<FrontEndWords> simulate(std::span<const Frame> frames, int beat, Scheduler& scheduler);

}  // namespace sailmap::csim
