// One level of the pyramid (spec 3), several pixels a word; the width of level `Fine` is a multiple of them.
//
// One stage a channel: 0 is the intensity, 1 to 4 are green, blue, red and yellow. Stream in: words of Count
// = 2 or 4 pixels, or, for Count = 8, two streams: the left and the right four pixels of each beat. Out:
// words of Count / 2 pixels. Formats: grey_sum (level 0) or intensity, colour. Latency: 2 rows and 1 word.
// II 1. Error: see pyramid.hpp.
//
// The rows of a frame run on into each other: a word's sums wait for the next word, at the end of a row for
// the first of the next row, so that no cycle is lost between rows.
#pragma once

#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/pyramid.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

template <class Config, int Fine, int Count>
struct ReduceLanes {
  static constexpr int fine = Fine;
  static constexpr int columns = Config::level_width(Fine) / Count;
};

template <class T>
inline T last_lane(const Lanes<1, T>& p) {
  return p.first;
}
template <int Count, class T>
inline T last_lane(const Lanes<Count, T>& p) {
  return last_lane(p.rest);
}
template <class T>
inline T last_but_one_lane(const Lanes<2, T>& p) {
  return p.first;
}
template <int Count, class T>
inline T last_but_one_lane(const Lanes<Count, T>& p) {
  return last_but_one_lane(p.rest);
}

// Adds the pixels of a beat; a and b are the two before it, `after` the one behind.
template <class Stage, int Channel>
inline void add_lanes(int x, uint16_t a, uint16_t b, const Lanes<2, uint16_t>& p, uint16_t after,
                      uint32_t kind, Lanes<1, uint16_t>& out) {
  const FiveTaps taps = {a, b, p.first, p.rest.first, after};
  out.first = add_to_column<Stage, Channel, 1>(x, taps, kind);
}
template <class Stage, int Channel, int Count>
inline void add_lanes(int x, uint16_t a, uint16_t b, const Lanes<Count, uint16_t>& p, uint16_t after,
                      uint32_t kind, Lanes<Count / 2, uint16_t>& out) {
  const FiveTaps taps = {a, b, p.first, p.rest.first, p.rest.rest.first};
  out.first = add_to_column<Stage, Channel, Count / 2>(x, taps, kind);
  add_lanes<Stage, Channel>(x, p.first, p.rest.first, p.rest.rest, after, kind, out.rest);
}

// What a channel remembers along a row: the beat worked on, the one behind it and the two pixels before it.
template <int Count>
struct BeatWindow {
  uint16_t a, b;
  Lanes<Count, uint16_t> now;
  Lanes<Count, uint16_t> next;

  // To the next beat; `first` says that it begins a row, before which its first pixel is replicated.
  void advance(bool first) {
    a = first ? next.first : last_but_one_lane(now);
    b = first ? next.first : last_lane(now);
    now = next;
  }
};

// Adds the beat at column word x; `last` says that it ends a row. Returns the samples of the next level.
template <class Stage, int Channel, int Count>
inline lanes_t<Count / 2> add_beat(int x, const BeatWindow<Count>& window, bool last, uint32_t kind) {
  const uint16_t after = last ? last_lane(window.now) : window.next.first;
  Lanes<Count / 2, uint16_t> out = Lanes<Count / 2, uint16_t>();
  add_lanes<Stage, Channel>(x, window.a, window.b, window.now, after, kind, out);
  return packed<lanes_t<Count / 2> >(out);
}

// Where the flat loop over a frame is, and over the row behind it.
struct BeatPosition {
  int x;
  int y;
  void advance(int beats) {
    const bool end = x + 1 == beats;
    y = end ? y + 1 : y;
    x = end ? 0 : x + 1;
  }
  bool reads_next(int beats, int height) const {
    return y + 1 < height || (y + 1 == height && x + 1 < beats);
  }
};

template <class Config, int Fine, int Count, int Channel>
void reduce_lanes(stream<lanes_t<Count> >& in, stream<lanes_t<Count / 2> >& out, uint16_t width,
                  uint16_t height) {
  using Stage = ReduceLanes<Config, Fine, Count>;
  const int h = Config::rows(height, Fine);
  const int beats = Config::columns(width, Fine) / Count;
  BeatWindow<Count> window = BeatWindow<Count>();
  unpack(in.read(), window.next);
#pragma nounroll
  for (BeatPosition at = {0, 0}; at.y <= h; at.advance(beats)) {
    SAILMAP_PIPELINE
    window.advance(at.x == 0);
    if (at.reads_next(beats, h)) unpack(in.read(), window.next);
    const uint32_t kind = row_kind::of(at.y, h);
    const lanes_t<Count / 2> word = add_beat<Stage, Channel>(at.x, window, at.x + 1 == beats, kind);
    if (row_kind::emits(kind)) out.write(word);
  }
}

// Eight pixels from the words of their left and right halves.
inline void unpack_halves(uint64_t left, uint64_t right, Lanes<8, uint16_t>& out) {
  unpack(left, out);
  unpack(right, out.rest.rest.rest.rest);
}

template <class Config, int Fine, int Channel>
void reduce_halves(stream<uint64_t>& left, stream<uint64_t>& right, stream<uint64_t>& out, uint16_t width,
                   uint16_t height) {
  using Stage = ReduceLanes<Config, Fine, 8>;
  const int h = Config::rows(height, Fine);
  const int beats = Config::columns(width, Fine) / 8;
  BeatWindow<8> window = BeatWindow<8>();
  unpack_halves(left.read(), right.read(), window.next);
#pragma nounroll
  for (BeatPosition at = {0, 0}; at.y <= h; at.advance(beats)) {
    SAILMAP_PIPELINE
    window.advance(at.x == 0);
    if (at.reads_next(beats, h)) unpack_halves(left.read(), right.read(), window.next);
    const uint32_t kind = row_kind::of(at.y, h);
    const lanes_t<4> word = add_beat<Stage, Channel>(at.x, window, at.x + 1 == beats, kind);
    if (row_kind::emits(kind)) out.write(word);
  }
}

// From words of Count = 1 or 2 pixels on five streams to one pixel a word, colours as lanes: the form of the
// levels that carry maps. II: Count cycles a word.
template <class Config, int Level>
void serialise_1(stream<uint16_t>& intensity, stream<uint16_t>& green, stream<uint16_t>& blue,
                 stream<uint16_t>& red, stream<uint16_t>& yellow, stream<uint16_t>& intensity_out,
                 stream<uint64_t>& colours_out, uint16_t width, uint16_t height) {
  const int words = Config::columns(width, Level) * Config::rows(height, Level);
#pragma nounroll
  for (int i = 0; i < words; ++i) {
    SAILMAP_PIPELINE
    intensity_out.write(intensity.read());
    const uint16_t g = green.read();
    const uint16_t b = blue.read();
    const uint16_t r = red.read();
    const uint16_t y = yellow.read();
    colours_out.write(pack(g, b, r, y));
  }
}
template <class Config, int Level>
void serialise_2(stream<uint32_t>& intensity, stream<uint32_t>& green, stream<uint32_t>& blue,
                 stream<uint32_t>& red, stream<uint32_t>& yellow, stream<uint16_t>& intensity_out,
                 stream<uint64_t>& colours_out, uint16_t width, uint16_t height) {
  const int words = Config::columns(width, Level) / 2 * Config::rows(height, Level);
#pragma nounroll
  for (int i = 0; i < words; ++i) {
    SAILMAP_PIPELINE_II(2)
    const uint32_t grey = intensity.read();
    const uint32_t g = green.read();
    const uint32_t b = blue.read();
    const uint32_t r = red.read();
    const uint32_t y = yellow.read();
    intensity_out.write(lane<0>(grey));
    colours_out.write(pack(lane<0>(g), lane<0>(b), lane<0>(r), lane<0>(y)));
    intensity_out.write(lane<1>(grey));
    colours_out.write(pack(lane<1>(g), lane<1>(b), lane<1>(r), lane<1>(y)));
  }
}

}  // namespace hls
}  // namespace sailmap
