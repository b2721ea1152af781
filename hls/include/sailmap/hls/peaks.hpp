// Maximum and m of the conspicuity maps, section 7, without a store for them: they come twice.
//
// Streams, base level, raster order, C_I, C_C and C_O as lanes. In: the maps and their flags
// (local_maxima.hpp), twice. Out: `statistics`, for each lane its maximum and m, the number of local maxima
// above half of it (0 for a flat zero map), after the first pass; the maps in the second, as `maps_out`,
// which leaves the front end, and `out`. Latency: a pass and the longest list of a lane's local maxima, a
// quarter of the pixels at most. II 1. Exact.
#pragma once

#include "sailmap/hls/formats.hpp"
#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/kinds.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

// The most local maxima of the largest frame.
template <class Config>
constexpr int longest_list() {
  return geometry::most_maxima(Config::level_width(geometry::base_level),
                               Config::level_height(geometry::base_level));
}

// The local maxima of a lane, and one word more, into which what is none is written.
template <class Config, int Lane>
struct PeakList {
  static uint16_t values[longest_list<Config>() + 1];
};
template <class Config, int Lane>
SAILMAP_MEMORY uint16_t PeakList<Config, Lane>::values[longest_list<Config>() + 1];

// One lane: what its list holds are the local maxima so far that were above half of the maximum so far.
template <class Config, int Lane>
struct Peaks {
  using List = PeakList<Config, Lane>;
  uint16_t maximum;
  uint32_t listed;
  uint32_t maxima;

  void take(uint16_t value, bool is_maximum) {
    if (value > maximum) maximum = value;
    List::values[listed] = value;
    const bool high = 2 * static_cast<uint32_t>(value) > maximum;
    listed = (listed + (is_maximum && high ? 1U : 0U)) & geometry::ones(longest_list<Config>());
  }
  // To be called for every i up to the end of the longest list.
  void count(uint32_t i) {
    const bool high = 2 * static_cast<uint32_t>(List::values[i]) > maximum;
    maxima = narrow<formats::maxima_count::word>(maxima + (i < listed && high ? 1U : 0U));
  }
  void write(stream<uint32_t>& out) const {
    out.write(maximum);
    out.write(maxima);
  }
};

// Both passes are one loop, in which a word of flags is read with every word of the maps.
template <class Config>
void peaks(stream<uint64_t>& in, stream<uint8_t>& in_flags, stream<uint32_t>& statistics,
           stream<uint64_t>& maps_out, stream<uint64_t>& out, uint16_t width, uint16_t height) {
  const int pixels =
      Config::columns(width, geometry::base_level) * Config::rows(height, geometry::base_level);
  Peaks<Config, 0> intensity = Peaks<Config, 0>();
  Peaks<Config, 1> colour = Peaks<Config, 1>();
  Peaks<Config, 2> orientation = Peaks<Config, 2>();
#pragma nounroll
  for (int pass = 0; pass < passes; ++pass) {
#pragma nounroll
    for (int i = 0; i < pixels; ++i) {
      SAILMAP_PIPELINE
      const uint64_t word = in.read();
      const uint8_t flags = in_flags.read();
      if (pass == 0) {
        intensity.take(lane<0>(word), (flags & 1) != 0);
        colour.take(lane<1>(word), (flags & 2) != 0);
        orientation.take(lane<2>(word), (flags & 4) != 0);
      } else {
        maps_out.write(word);
        out.write(word);
      }
    }
    if (pass == 0) {
      const uint32_t longer = intensity.listed > colour.listed ? intensity.listed : colour.listed;
      const uint32_t longest = longer > orientation.listed ? longer : orientation.listed;
#pragma nounroll
      for (uint32_t k = 0; k < longest; ++k) {
        SAILMAP_PIPELINE
        intensity.count(k);
        colour.count(k);
        orientation.count(k);
      }
      intensity.write(statistics);
      colour.write(statistics);
      orientation.write(statistics);
    }
  }
}

}  // namespace hls
}  // namespace sailmap
