// What the hardware must put out for a frame, computed by the quantised reference: the same words, from real
// numbers.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "sailmap/csim/frame.hpp"
#include "sailmap/ref/model.hpp"
#include "sailmap/ref/quantised.hpp"

namespace sailmap::testing {

// The raw integer of a value at a named point. Throws when the value is no multiple of the point's unit in
// the last place.
template <class Point>
std::uint64_t raw(double value) {
  const double scaled = std::ldexp(value, Point::fraction);
  if (scaled != std::floor(scaled) || scaled < 0) throw std::logic_error("a value off its format");
  return static_cast<std::uint64_t>(scaled);
}

// The maps as lanes of 16 bits, the first in the low bits.
template <class Word, class Point, std::size_t Count>
std::vector<Word> lanes(const std::array<const Plane<double>*, Count>& maps) {
  std::vector<Word> words(maps[0]->samples().size());
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::uint64_t word = 0;
    for (std::size_t lane = 0; lane < Count; ++lane) {
      word |= raw<Point>(maps[lane]->samples()[i]) << (16 * lane);
    }
    words[i] = static_cast<Word>(word);
  }
  return words;
}

// Two maps wider than 16 bits, 32 bits each, the first in the low bits.
template <class Point>
std::vector<std::uint64_t> wide_pair(const Plane<double>& first, const Plane<double>& second) {
  std::vector<std::uint64_t> words(first.samples().size());
  for (std::size_t i = 0; i < words.size(); ++i) {
    words[i] = raw<Point>(first.samples()[i]) | raw<Point>(second.samples()[i]) << 32;
  }
  return words;
}

inline ImageView view(const csim::Frame& frame) {
  return {frame.width, frame.height, frame.rgb.data(), 3L * frame.width, ChannelOrder::rgb};
}

template <class Point>
void append_statistics(const MapStatistics& statistics, std::vector<std::uint32_t>& words) {
  words.push_back(static_cast<std::uint32_t>(raw<Point>(statistics.maximum)));
  words.push_back(static_cast<std::uint32_t>(statistics.maxima));
}

// What the front end puts out of a frame, its maps being the quantised reference's.
inline csim::FrontEndWords words_of(const ref::Model& model) {
  namespace point = ref::point;
  const auto& f = model.features;
  const auto& c = model.conspicuities;
  csim::FrontEndWords words;
  words.intensity_maps = lanes<std::uint32_t, point::intensity_feature, 2>({&f[0], &f[1]});
  words.colour_maps = lanes<std::uint64_t, point::colour_feature, 4>({&f[2], &f[3], &f[4], &f[5]});
  words.orientation_maps = lanes<std::uint64_t, point::orientation_feature, 4>({&f[6], &f[7], &f[8], &f[9]});
  words.conspicuity_maps.resize(c[0].samples().size());
  for (std::size_t i = 0; i < words.conspicuity_maps.size(); ++i) {
    words.conspicuity_maps[i] = raw<point::intensity_conspicuity>(c[0].samples()[i]) |
                                raw<point::colour_conspicuity>(c[1].samples()[i]) << 16 |
                                raw<point::orientation_conspicuity>(c[2].samples()[i]) << 32;
  }
  words.saliency = lanes<std::uint16_t, point::saliency, 1>({&model.saliency});
  for (std::size_t i = 0; i < f.size(); ++i) {
    const MapStatistics& statistics = model.feature_statistics[i];
    if (i < 2) {
      append_statistics<point::intensity_feature>(statistics, words.statistics);
    } else if (i < 6) {
      append_statistics<point::colour_feature>(statistics, words.statistics);
    } else {
      append_statistics<point::orientation_feature>(statistics, words.statistics);
    }
  }
  append_statistics<point::intensity_conspicuity>(model.conspicuity_statistics[0], words.statistics);
  append_statistics<point::colour_conspicuity>(model.conspicuity_statistics[1], words.statistics);
  append_statistics<point::orientation_conspicuity>(model.conspicuity_statistics[2], words.statistics);
  return words;
}

inline csim::FrontEndWords expected(const csim::Frame& frame) {
  return words_of(ref::compute<ref::Quantised>(view(frame)));
}

// The words of a frame in both passes (kinds.hpp).
template <class Word>
std::vector<Word> twice(std::vector<Word> words) {
  const std::vector<Word> once = words;
  words.insert(words.end(), once.begin(), once.end());
  return words;
}

}  // namespace sailmap::testing
