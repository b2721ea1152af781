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

// Block memories are 36 bits wide where they have 1024 words: room for two maps and their flags, which are
// above the maps. So four maps are in two words, three in a word of two, with all flags, and one of one. What
// of a native word is never used, Yosys makes no memory for.
constexpr int stored_pair_bits = 2 * lane_bits + 2;

template <class Config, int Kind, int Bank, int Pair>
struct StoredPair {
  static uint64_t words[Config::level_pixels(geometry::base_level)];
};
template <class Config, int Kind, int Bank, int Pair>
SAILMAP_MEMORY uint64_t
    StoredPair<Config, Kind, Bank, Pair>::words[Config::level_pixels(geometry::base_level)];

template <class Config, int Kind, int Bank>
struct StoredMap {
  static uint16_t words[Config::level_pixels(geometry::base_level)];
};
template <class Config, int Kind, int Bank>
SAILMAP_MEMORY uint16_t StoredMap<Config, Kind, Bank>::words[Config::level_pixels(geometry::base_level)];

inline uint64_t with_flags(uint32_t maps, uint8_t flags) {
  return static_cast<uint64_t>(flags) << (2 * lane_bits) | maps;
}
inline uint8_t flags_of(uint64_t stored) { return static_cast<uint8_t>(stored >> (2 * lane_bits) & 7U); }

// The words of a pixel, low and high, and what is in them. The memories are read once a pixel.
template <class Config, int Count, int Kind, int Bank>
struct StoredMaps;

template <class Config, int Kind, int Bank>
struct StoredMaps<Config, 2, Kind, Bank> {
  using Low = StoredPair<Config, Kind, Bank, 0>;

  static void put(unsigned i, uint32_t maps, uint8_t flags) { Low::words[i] = with_flags(maps, flags & 3U); }
  static uint64_t low(unsigned i) { return Low::words[i]; }
  static uint64_t high(unsigned /*i*/) { return 0; }
  static uint32_t maps(uint64_t low, uint64_t /*high*/) { return static_cast<uint32_t>(low); }
  static uint8_t flags(uint64_t low, uint64_t /*high*/) { return flags_of(low); }
};

template <class Config, int Kind, int Bank>
struct StoredMaps<Config, 3, Kind, Bank> {
  using Low = StoredPair<Config, Kind, Bank, 0>;
  using High = StoredMap<Config, Kind, Bank>;

  static void put(unsigned i, uint64_t maps, uint8_t flags) {
    Low::words[i] = with_flags(static_cast<uint32_t>(maps), flags & 7U);
    High::words[i] = lane<2>(maps);
  }
  static uint64_t low(unsigned i) { return Low::words[i]; }
  static uint64_t high(unsigned i) { return High::words[i]; }
  static uint64_t maps(uint64_t low, uint64_t high) {
    return wide_pair(static_cast<uint32_t>(low), lane<0>(high));
  }
  static uint8_t flags(uint64_t low, uint64_t /*high*/) { return flags_of(low); }
};

template <class Config, int Kind, int Bank>
struct StoredMaps<Config, 4, Kind, Bank> {
  using Low = StoredPair<Config, Kind, Bank, 0>;
  using High = StoredPair<Config, Kind, Bank, 1>;

  static void put(unsigned i, uint64_t maps, uint8_t flags) {
    Low::words[i] = with_flags(static_cast<uint32_t>(maps), flags & 3U);
    High::words[i] = with_flags(static_cast<uint32_t>(maps >> 32), static_cast<uint8_t>(flags >> 2 & 3U));
  }
  static uint64_t low(unsigned i) { return Low::words[i]; }
  static uint64_t high(unsigned i) { return High::words[i]; }
  static uint64_t maps(uint64_t low, uint64_t high) {
    return wide_pair(static_cast<uint32_t>(low), static_cast<uint32_t>(high));
  }
  static uint8_t flags(uint64_t low, uint64_t high) {
    return static_cast<uint8_t>(flags_of(low) | flags_of(high) << 2);
  }
};

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
  const auto pixels = static_cast<unsigned>(Config::columns(width, geometry::base_level) *
                                            Config::rows(height, geometry::base_level));
  LaneStatistics<Count> lanes = LaneStatistics<Count>();
  lanes.clear();
#pragma nounroll
  for (unsigned i = 0; i < pixels; ++i) {
    SAILMAP_PIPELINE
    const lanes_t<Count> word = in.read();
    Maps::put(i, word, in_flags.read());
    lanes.take(word);
  }
#pragma nounroll
  for (unsigned i = 0; i < pixels; ++i) {
    SAILMAP_PIPELINE
    const uint64_t low = Maps::low(i);
    const uint64_t high = Maps::high(i);
    lanes.count(Maps::maps(low, high), Maps::flags(low, high));
  }
  lanes.write(statistics);
#pragma nounroll
  for (unsigned i = 0; i < pixels; ++i) {
    SAILMAP_PIPELINE
    out.write(Maps::maps(Maps::low(i), Maps::high(i)));
  }
}

}  // namespace hls
}  // namespace sailmap
