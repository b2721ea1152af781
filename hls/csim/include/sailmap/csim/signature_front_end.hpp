// Runs a front end with the signature of any configuration in C simulation; signature.hpp has the largest
// one, compiled.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sailmap/csim/front_end.hpp"
#include "sailmap/csim/signature.hpp"
#include "sailmap/hls/signature_front_end.hpp"

namespace sailmap::csim {

// The records of frames back to back through one network, each frame of its own size. Throws
// std::invalid_argument when Config does not take a frame, NetworkError when the network is wrong.
template <class Config>
std::vector<std::vector<std::uint32_t>> run_signature_front_end(std::span<const Frame> frames,
                                                                const SignatureParameters& parameters,
                                                                Scheduler& scheduler) {
  demand_sizes<Config>(frames);
  PixelStreams<Config::beat> pixels;
  Stream<std::uint32_t> record("record");
  pixels.feed(scheduler, frames);
  for (const Frame& frame : frames) {
    hls::SignatureFrontEnd<Config>::run(pixels.red, pixels.green, pixels.blue, record,
                                        static_cast<std::uint16_t>(frame.width),
                                        static_cast<std::uint16_t>(frame.height), parameters.max_regions,
                                        parameters.stop_ratio, parameters.box_side);
  }
  std::vector<std::vector<std::uint32_t>> records(frames.size());
  scheduler.launch("sink of record", {&record}, [&] {
    for (auto& words : records) read_words(record, hls::signature_record::words, words);
  });
  scheduler.run();
  return records;
}

}  // namespace sailmap::csim
