// The frame store of section 7: keeps the maps of a frame while it finds their maxima, then replays them.
//
// Streams, base level, Count maps as lanes. In: the maps and their local-maximum flags (local_maxima.hpp),
// raster order. Out: `statistics`, for each lane its maximum and m, the number of local maxima above half of
// it (0 for a flat zero map), then the maps again. Latency: a frame, and a second pass over it that counts.
// II 1 in all three passes; a frame of n base pixels keeps the store for n to fill, n to count and n to
// replay. Exact. `Kind` and `Bank` tell the instances apart.
#pragma once

#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/kinds.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

template <class Config, int Count, int Kind, int Bank>
struct StoreMemory {
  static lanes_t<Count> words[Config::level_pixels(geometry::base_level)];
  static uint8_t flags[Config::level_pixels(geometry::base_level)];
};
template <class Config, int Count, int Kind, int Bank>
SAILMAP_MEMORY lanes_t<Count>
    StoreMemory<Config, Count, Kind, Bank>::words[Config::level_pixels(geometry::base_level)];
template <class Config, int Count, int Kind, int Bank>
SAILMAP_MEMORY uint8_t
    StoreMemory<Config, Count, Kind, Bank>::flags[Config::level_pixels(geometry::base_level)];

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
    maxima += (flags & 1) != 0 && high ? 1 : 0;
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
  using Memory = StoreMemory<Config, Count, Kind, Bank>;
  const int pixels = geometry::base_side(width) * geometry::base_side(height);
  LaneStatistics<Count> lanes = LaneStatistics<Count>();
  lanes.clear();
#pragma nounroll
  for (int i = 0; i < pixels; ++i) {
    SAILMAP_PIPELINE
    const lanes_t<Count> word = in.read();
    Memory::words[i] = word;
    Memory::flags[i] = in_flags.read();
    lanes.take(word);
  }
#pragma nounroll
  for (int i = 0; i < pixels; ++i) {
    SAILMAP_PIPELINE
    lanes.count(Memory::words[i], Memory::flags[i]);
  }
  lanes.write(statistics);
#pragma nounroll
  for (int i = 0; i < pixels; ++i) {
    SAILMAP_PIPELINE
    out.write(Memory::words[i]);
  }
}

}  // namespace hls
}  // namespace sailmap
