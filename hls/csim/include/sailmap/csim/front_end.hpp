// Runs a front end of any configuration in C simulation; simulate.hpp has the largest one, compiled.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "sailmap/csim/frame.hpp"
#include "sailmap/csim/scheduler.hpp"
#include "sailmap/csim/stream.hpp"
#include "sailmap/hls/front_end.hpp"

namespace sailmap::csim {

// Writes one component of frames, `Beat` pixels a word, the left one in the low byte.
template <int Beat>
void write_component(Stream<hls::bytes_t<Beat>>& out, const Frame& frame, std::size_t component) {
  const std::size_t pixels = frame.rgb.size() / 3;
  for (std::size_t i = 0; i < pixels; i += Beat) {
    std::uint64_t word = 0;
    for (std::size_t k = 0; k < Beat; ++k) {
      word |= static_cast<std::uint64_t>(frame.rgb[3 * (i + k) + component]) << (8 * k);
    }
    out.write(static_cast<hls::bytes_t<Beat>>(word));
  }
}

template <class T>
void read_words(Stream<T>& in, std::size_t count, std::vector<T>& out) {
  out.resize(count);
  for (T& word : out) word = in.read();
}

// One component of frames back to back into a network.
template <int Beat>
void feed_component(Scheduler& scheduler, Stream<hls::bytes_t<Beat>>& stream, std::span<const Frame> frames,
                    std::size_t component) {
  scheduler.launch("source of " + stream.name(), {&stream}, [frames, &stream, component] {
    for (const Frame& frame : frames) write_component<Beat>(stream, frame, component);
  });
}

// What every network of a front end takes in, and who feeds it.
template <int Beat>
struct PixelStreams {
  Stream<hls::bytes_t<Beat>> red{"red"}, green{"green"}, blue{"blue"};

  void feed(Scheduler& scheduler, std::span<const Frame> frames) {
    feed_component<Beat>(scheduler, red, frames, 0);
    feed_component<Beat>(scheduler, green, frames, 1);
    feed_component<Beat>(scheduler, blue, frames, 2);
  }
};

// Throws std::invalid_argument when Config does not take a frame.
template <class Config>
void demand_sizes(std::span<const Frame> frames) {
  for (const Frame& frame : frames) {
    if (Config::takes(frame.width, frame.height)) continue;
    throw std::invalid_argument("a frame of " + std::to_string(frame.width) + "x" +
                                std::to_string(frame.height) + " pixels does not fit a front end of " +
                                std::to_string(Config::max_width) + "x" + std::to_string(Config::max_height) +
                                " with " + std::to_string(Config::beat) + " pixels a beat");
  }
}

// Back to back through one network, each frame of its own size. Throws std::invalid_argument when Config does
// not take a frame, NetworkError when the network is wrong.
template <class Config>
std::vector<FrontEndWords> run_front_end(std::span<const Frame> frames, Scheduler& scheduler) {
  demand_sizes<Config>(frames);
  PixelStreams<Config::beat> pixels;
  Stream<std::uint32_t> intensity_maps("intensity_maps");
  Stream<std::uint64_t> colour_maps("colour_maps");
  Stream<std::uint64_t> orientation_maps("orientation_maps");
  Stream<std::uint64_t> conspicuity_maps("conspicuity_maps");
  Stream<std::uint16_t> saliency("saliency");
  Stream<std::uint32_t> statistics("statistics");
  std::vector<FrontEndWords> out(frames.size());

  pixels.feed(scheduler, frames);
  for (const Frame& frame : frames) {
    hls::FrontEnd<Config>::run(pixels.red, pixels.green, pixels.blue, intensity_maps, colour_maps,
                               orientation_maps, conspicuity_maps, saliency, statistics,
                               static_cast<std::uint16_t>(frame.width),
                               static_cast<std::uint16_t>(frame.height));
  }
  const auto drain = [&](const char* name, auto& stream, auto FrontEndWords::*words) {
    scheduler.launch(name, {&stream}, [frames, &stream, &out, words] {
      for (std::size_t i = 0; i < frames.size(); ++i) {
        const std::size_t count = static_cast<std::size_t>(hls::geometry::base_side(frames[i].width)) *
                                  static_cast<std::size_t>(hls::geometry::base_side(frames[i].height));
        read_words(stream, count, out[i].*words);
      }
    });
  };
  drain("sink of intensity_maps", intensity_maps, &FrontEndWords::intensity_maps);
  drain("sink of colour_maps", colour_maps, &FrontEndWords::colour_maps);
  drain("sink of orientation_maps", orientation_maps, &FrontEndWords::orientation_maps);
  drain("sink of conspicuity_maps", conspicuity_maps, &FrontEndWords::conspicuity_maps);
  drain("sink of saliency", saliency, &FrontEndWords::saliency);
  scheduler.launch("sink of statistics", {&statistics}, [&] {
    for (FrontEndWords& words : out) read_words(statistics, hls::statistics_words, words.statistics);
  });
  scheduler.run();
  return out;
}

}  // namespace sailmap::csim
