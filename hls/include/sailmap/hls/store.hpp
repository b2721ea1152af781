// The frame store of section 7: keeps the feature maps of a frame while it finds their maxima, then replays
// them twice (kinds.hpp says why).
//
// Streams, base level, Count maps as lanes. In: the maps and their flags (local_maxima.hpp), raster order.
// Out: `statistics`, for each lane its maximum and m, the number of local maxima above half of it (0 for a
// flat zero map), then the maps: as `out` twice, and beside the first time as `maps_out`, which leaves the
// front end. Latency: a frame, and a second pass over it that counts. II 1 in all passes; a frame of n base
// pixels keeps the store for n to fill, n to count and 2 n to replay. Of the last n nothing is lost: behind
// the second replay, in the memory that it leaves, the store takes in what there is of the next frame,
// without waiting for it, all but that frame's last pixel. Exact. `Kind` and `Bank` tell the instances apart.
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
// above the maps. What of a native word is never used, Yosys makes no memory for.
constexpr int stored_pair_bits = 2 * lane_bits + 2;

template <class Config, int Kind, int Bank, int Pair>
struct StoredPair {
  static uint64_t words[Config::level_pixels(geometry::base_level)];
};
template <class Config, int Kind, int Bank, int Pair>
SAILMAP_MEMORY uint64_t
    StoredPair<Config, Kind, Bank, Pair>::words[Config::level_pixels(geometry::base_level)];

inline uint64_t with_flags(uint32_t maps, uint8_t flags) {
  return static_cast<uint64_t>(flags) << (2 * lane_bits) | maps;
}
inline uint8_t flags_of(uint64_t stored) { return static_cast<uint8_t>(stored >> (2 * lane_bits) & 3U); }

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

// What a store has taken in of the next frame: its first pixels, and each lane's maximum of these.
template <class Config, int Count, int Kind, int Bank>
struct TakenAhead {
  static uint32_t pixels;
  static lanes_t<Count> maxima;
};
template <class Config, int Count, int Kind, int Bank>
uint32_t TakenAhead<Config, Count, Kind, Bank>::pixels = 0;
template <class Config, int Count, int Kind, int Bank>
lanes_t<Count> TakenAhead<Config, Count, Kind, Bank>::maxima = 0;

// The larger of each lane.
template <int Count>
struct LaneMaxima {
  template <class Word>
  static Word of(Word a, Word b) {
    const uint16_t larger = lane<0>(a) > lane<0>(b) ? lane<0>(a) : lane<0>(b);
    const Word rest =
        LaneMaxima<Count - 1>::of(static_cast<Word>(a >> lane_bits), static_cast<Word>(b >> lane_bits));
    return static_cast<Word>(rest << lane_bits | larger);
  }
};
template <>
struct LaneMaxima<0> {
  template <class Word>
  static Word of(Word /*a*/, Word /*b*/) {
    return 0;
  }
};

// Maximum and m of each lane.
template <int Count>
struct LaneStatistics {
  uint16_t maximum;
  uint32_t maxima;
  LaneStatistics<Count - 1> rest;

  template <class Word>
  void begin(Word largest) {
    maximum = lane<0>(largest);
    maxima = 0;
    rest.begin(static_cast<Word>(largest >> lane_bits));
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
  template <class Word>
  void begin(Word /*largest*/) {}
  template <class Word>
  void count(Word /*word*/, uint8_t /*flags*/) {}
  void write(stream<uint32_t>& /*out*/) const {}
};

// A frame's pixels so far, and each lane's maximum of them.
template <int Count>
struct FrameSoFar {
  uint32_t pixels;
  lanes_t<Count> maxima;
};

template <class Config, int Count, int Kind, int Bank>
SAILMAP_INLINED FrameSoFar<Count> with_pixel(const FrameSoFar<Count>& so_far, lanes_t<Count> word,
                                             uint8_t flags) {
  const bool first = (flags & start_of_frame) != 0;
  const uint32_t at = first ? 0 : so_far.pixels;
  StoredMaps<Config, Count, Kind, Bank>::put(at, word, flags);
  const FrameSoFar<Count> out = {
      static_cast<uint32_t>((at + 1) & geometry::ones(Config::level_pixels(geometry::base_level))),
      LaneMaxima<Count>::of(word, first ? lanes_t<Count>{0} : so_far.maxima)};
  return out;
}

template <class Config, int Count, int Kind, int Bank>
void store(stream<lanes_t<Count> >& in, stream<uint8_t>& in_flags, stream<uint32_t>& statistics,
           stream<lanes_t<Count> >& maps_out, stream<lanes_t<Count> >& out, uint16_t width, uint16_t height) {
  using Maps = StoredMaps<Config, Count, Kind, Bank>;
  using Ahead = TakenAhead<Config, Count, Kind, Bank>;
  const auto pixels = static_cast<unsigned>(Config::columns(width, geometry::base_level) *
                                            Config::rows(height, geometry::base_level));
  // One pixel at least, so that a frame that was not taken in to its end is forgotten.
  FrameSoFar<Count> frame = {Ahead::pixels, Ahead::maxima};
  do {
    SAILMAP_PIPELINE
    const lanes_t<Count> word = in.read();
    frame = with_pixel<Config, Count, Kind, Bank>(frame, word, in_flags.read());
  } while (frame.pixels < pixels);
  LaneStatistics<Count> lanes = LaneStatistics<Count>();
  lanes.begin(frame.maxima);
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
    const lanes_t<Count> word = Maps::maps(Maps::low(i), Maps::high(i));
    maps_out.write(word);
    out.write(word);
  }
  // The next frame is never ahead of what is read of this one.
  FrameSoFar<Count> next = {0, 0};
  bool open = true;
#pragma nounroll
  for (unsigned i = 0; i < pixels; ++i) {
    SAILMAP_PIPELINE
    out.write(Maps::maps(Maps::low(i), Maps::high(i)));
    // The flags come behind their word, so where there are some nothing need be waited for.
    uint8_t flags = 0;
    if (open && try_read(in_flags, flags)) {
      next = with_pixel<Config, Count, Kind, Bank>(next, in.read(), flags);
      open = (flags & last_but_one) == 0;
    }
  }
  Ahead::pixels = next.pixels;
  Ahead::maxima = next.maxima;
}

}  // namespace hls
}  // namespace sailmap
