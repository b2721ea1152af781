// The frame store of section 7: keeps the maps of a frame while it finds their maxima, then replays them.
//
// Streams, base level, Count maps as lanes. In: the maps and their local-maximum flags (local_maxima.hpp),
// raster order. Out: `statistics`, for each lane its maximum and m, the number of local maxima above half of
// it (0 for a flat zero map), then the maps again. Latency: a frame, and a second pass over it that counts.
// II 1 in all three passes; a frame of n base pixels keeps the store for n to fill, n to count and n to
// replay. Exact. `Kind` and `Bank` tell the instances apart.
#pragma once

#include "sailmap/hls/formats.hpp"
#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/kinds.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

// The flags of several pixels share a word, so that they fill block memories. `put` gathers them, the newest
// pixel in the low bits; the pass that counts goes backwards and finds them low, however many pixels the last
// word has.
template <class Config, int Count, int Kind, int Bank>
struct StoredFlags {
  static constexpr int bits = Count == 2 ? 2 : 4;
  static constexpr int in_word = 32 / bits;
  static constexpr int size = (Config::level_pixels(geometry::base_level) + in_word - 1) / in_word;
  static uint32_t words[size];

  // Pixel i, after pixel i - 1; returns the flags so far, to be given back with the next pixel.
  static uint32_t put(unsigned i, uint32_t so_far, uint8_t flags) {
    const uint32_t gathered = so_far << bits | flags;
    words[i / in_word] = gathered;
    return gathered;
  }
  // Pixel i in the low bits, after pixel i + 1, with which `so_far` was returned; the last pixel starts.
  static uint32_t get(unsigned i, bool is_last, uint32_t so_far) {
    const uint32_t word = words[i / in_word];
    return is_last || i % in_word == in_word - 1 ? word : so_far >> bits;
  }
};
template <class Config, int Count, int Kind, int Bank>
SAILMAP_MEMORY uint32_t StoredFlags<Config, Count, Kind, Bank>::words[size];

// The maps: two or four lanes a word, three in a word of two and one of one.
template <class Config, int Count, int Kind, int Bank>
struct StoredMaps {
  static lanes_t<Count> words[Config::level_pixels(geometry::base_level)];

  static void put(unsigned i, lanes_t<Count> word) { words[i] = word; }
  static lanes_t<Count> get(unsigned i) { return words[i]; }
};
template <class Config, int Count, int Kind, int Bank>
SAILMAP_MEMORY lanes_t<Count>
    StoredMaps<Config, Count, Kind, Bank>::words[Config::level_pixels(geometry::base_level)];

template <class Config, int Kind, int Bank>
struct StoredMaps<Config, 3, Kind, Bank> {
  static uint32_t low[Config::level_pixels(geometry::base_level)];
  static uint16_t high[Config::level_pixels(geometry::base_level)];

  static void put(unsigned i, lanes_t<3> word) {
    low[i] = static_cast<uint32_t>(word);
    high[i] = lane<2>(word);
  }
  static lanes_t<3> get(unsigned i) { return static_cast<lanes_t<3> >(high[i]) << 32 | low[i]; }
};
template <class Config, int Kind, int Bank>
SAILMAP_MEMORY uint32_t StoredMaps<Config, 3, Kind, Bank>::low[Config::level_pixels(geometry::base_level)];
template <class Config, int Kind, int Bank>
SAILMAP_MEMORY uint16_t StoredMaps<Config, 3, Kind, Bank>::high[Config::level_pixels(geometry::base_level)];

// Maximum and m of each lane.
template <int Count>
struct LaneStatistics {
  uint16_t maximum;
  uint32_t maxima;
  LaneStatistics<Count - 1> rest;

  void clear() {
    maximum = 0;
    maxima = 0;
    rest.clear();
  }
  template <class Word>
  void take(Word word) {
    if (lane<0>(word) > maximum) maximum = lane<0>(word);
    rest.take(static_cast<Word>(word >> lane_bits));
  }
  // To be called for every pixel after the maxima are known.
  template <class Word>
  void count(Word word, uint8_t flags) {
    const bool high = 2 * static_cast<uint32_t>(lane<0>(word)) > maximum;
    maxima = narrow<formats::maxima_count::word>(maxima + ((flags & 1) != 0 && high ? 1U : 0U));
    rest.count(static_cast<Word>(word >> lane_bits), static_cast<uint8_t>(flags >> 1));
  }
  void write(stream<uint32_t>& out) const {
    out.write(maximum);
    out.write(maxima);
    rest.write(out);
  }
};
template <>
struct LaneStatistics<0> {
  void clear() {}
  template <class Word>
  void take(Word /*word*/) {}
  template <class Word>
  void count(Word /*word*/, uint8_t /*flags*/) {}
  void write(stream<uint32_t>& /*out*/) const {}
};

template <class Config, int Count, int Kind, int Bank>
void store(stream<lanes_t<Count> >& in, stream<uint8_t>& in_flags, stream<uint32_t>& statistics,
           stream<lanes_t<Count> >& out, uint16_t width, uint16_t height) {
  using Maps = StoredMaps<Config, Count, Kind, Bank>;
  using Flags = StoredFlags<Config, Count, Kind, Bank>;
  const auto pixels = static_cast<unsigned>(Config::columns(width, geometry::base_level) *
                                            Config::rows(height, geometry::base_level));
  LaneStatistics<Count> lanes = LaneStatistics<Count>();
  lanes.clear();
  uint32_t flags = 0;
#pragma nounroll
  for (unsigned i = 0; i < pixels; ++i) {
    SAILMAP_PIPELINE
    const lanes_t<Count> word = in.read();
    Maps::put(i, word);
    flags = Flags::put(i, flags, in_flags.read());
    lanes.take(word);
  }
#pragma nounroll
  for (unsigned left = pixels; left > 0; --left) {
    SAILMAP_PIPELINE
    const unsigned i = left - 1;
    flags = Flags::get(i, left == pixels, flags);
    lanes.count(Maps::get(i), static_cast<uint8_t>(flags));
  }
  lanes.write(statistics);
#pragma nounroll
  for (unsigned i = 0; i < pixels; ++i) {
    SAILMAP_PIPELINE
    out.write(Maps::get(i));
  }
}

}  // namespace hls
}  // namespace sailmap
