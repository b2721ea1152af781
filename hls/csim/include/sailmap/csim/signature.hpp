// The signature kernel in C simulation, alone or behind the front end: what the front end put out of a frame,
// or the frame, goes in, the packed record of hls/signature_record.hpp comes out.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sailmap/csim/frame.hpp"
#include "sailmap/csim/scheduler.hpp"

namespace sailmap::csim {

// As the kernel takes them: sailmap/hls/signature.hpp.
struct SignatureParameters {
  std::uint16_t max_regions = 20;
  std::uint32_t stop_ratio = 1U << 14;  // a quarter
  std::uint16_t box_side = 10;
};

// Of a frame of 64 to 4096 pixels a side. Calls take turns, as those of simulate() do. Throws
// std::invalid_argument when the words are not those of such a frame.
std::vector<std::uint32_t> simulate_signature(const FrontEndWords& words, int width, int height,
                                              const SignatureParameters& parameters, Scheduler& scheduler);

// Of frames back to back through one network of front end and signature; as simulate() in simulate.hpp.
std::vector<std::vector<std::uint32_t>> simulate_records(std::span<const Frame> frames, int beat,
                                                         const SignatureParameters& parameters,
                                                         Scheduler& scheduler);

}  // namespace sailmap::csim
