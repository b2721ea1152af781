// The front end for frames of any size, without and with the signature; each beat is compiled in a file of
// its own, simulate_BEAT.cpp.
#pragma once

#include <mutex>
#include <stdexcept>
#include <string>

#include "sailmap/csim/front_end.hpp"
#include "sailmap/csim/signature_front_end.hpp"
#include "sailmap/hls/config.hpp"

namespace sailmap::csim {

template <int Beat>
using Largest = hls::Config<hls::geometry::max_image_side, hls::geometry::max_image_side, Beat>;

using Records = std::vector<std::vector<std::uint32_t>>;
#define SAILMAP_LARGEST(prefix, beat)                                                             \
  prefix template std::vector<FrontEndWords> run_front_end<Largest<beat>>(std::span<const Frame>, \
                                                                          Scheduler&);            \
  prefix template Records run_signature_front_end<Largest<beat>>(std::span<const Frame>,          \
                                                                 const SignatureParameters&, Scheduler&)
SAILMAP_LARGEST(extern, 1);
SAILMAP_LARGEST(extern, 2);
SAILMAP_LARGEST(extern, 4);
SAILMAP_LARGEST(extern, 8);

// Kernels keep state in statics, which all simulations of a beat have in common.
std::mutex& one_at_a_time();

// Calls `run` with the configuration of that beat. Throws std::invalid_argument when there is none.
template <class Run>
auto with_largest(int beat, Run run) {
  const std::lock_guard lock(one_at_a_time());
  switch (beat) {
    case 1:
      return run(Largest<1>());
    case 2:
      return run(Largest<2>());
    case 4:
      return run(Largest<4>());
    case 8:
      return run(Largest<8>());
    default:
      throw std::invalid_argument("no front end takes " + std::to_string(beat) + " pixels a beat");
  }
}

}  // namespace sailmap::csim
