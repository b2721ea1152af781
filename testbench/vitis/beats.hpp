// Frames as the ports of the tops take them, as text: vectors of scripts/vitis/testbench.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "sailmap/csim/frame.hpp"

namespace sailmap::testing {

// `count` neighbouring words of `bits` bits as one, the left one low.
template <class Word, class Part>
std::vector<Word> grouped(const std::vector<Part>& parts, std::size_t count, int bits) {
  std::vector<Word> words(parts.size() / count);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::uint64_t shifted = std::uint64_t{parts[i]} << (bits * static_cast<int>(i % count));
    words[i / count] = static_cast<Word>(words[i / count] | shifted);
  }
  return words;
}

// Red, green or blue bytes, `beat` a word.
inline std::vector<std::uint64_t> bytes(const csim::Frame& frame, std::size_t component, std::size_t beat) {
  std::vector<std::uint8_t> samples;
  for (std::size_t i = component; i < frame.rgb.size(); i += 3) samples.push_back(frame.rgb[i]);
  return grouped<std::uint64_t>(samples, beat, 8);
}

// Beats of AXI4-Stream video: {R, B, G} of each pixel from high to low byte, the left pixel low; in
// hexadecimal.
inline std::vector<std::string> video(const csim::Frame& frame, std::size_t beat) {
  static constexpr const char* digits = "0123456789abcdef";
  std::vector<std::string> beats(frame.rgb.size() / (3 * beat));
  for (std::size_t i = 0; i < frame.rgb.size() / 3; ++i) {
    std::string pixel;
    for (const std::size_t component : {0U, 2U, 1U}) {
      const std::uint8_t byte = frame.rgb[3 * i + component];
      pixel += {digits[byte >> 4], digits[byte & 15]};
    }
    beats[i / beat].insert(0, pixel);
  }
  return beats;
}

// Beats of pixels in memory: R, G, B and a byte of any value from low to high, the left pixel low; in
// hexadecimal.
inline std::vector<std::string> memory_beats(const csim::Frame& frame, std::size_t beat) {
  std::vector<std::string> beats(frame.rgb.size() / (3 * beat));
  std::array<char, 9> pixel{};
  for (std::size_t i = 0; i < frame.rgb.size() / 3; ++i) {
    const std::uint8_t* rgb = &frame.rgb[3 * i];
    std::snprintf(pixel.data(), pixel.size(), "%02x%02x%02x%02x", static_cast<unsigned>(i % 256), rgb[2],
                  rgb[1], rgb[0]);
    beats[i / beat].insert(0, pixel.data());
  }
  return beats;
}

}  // namespace sailmap::testing
