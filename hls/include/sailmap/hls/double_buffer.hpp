// Double buffering of the frame stores: two stores that take turns, so that one frame is stored while the one
// before is counted and replayed. Stages take_turns -> store_in_turn (two) -> collect_turns; streams as those
// of store.hpp.
//
// `turn` words say whose frame it is: 0 for store A, 1 for B. Only take_turns remembers anything from frame
// to frame; the others are told, so that they cannot come to disagree.
#pragma once

#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/kinds.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/store.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

template <class Config, int Count, int Kind>
struct Turn {
  static uint8_t next;
};
template <class Config, int Count, int Kind>
uint8_t Turn<Config, Count, Kind>::next = 0;

template <class Config, int Count, int Kind>
void take_turns(stream<lanes_t<Count> >& in, stream<uint8_t>& in_flags, stream<uint8_t>& turn,
                stream<uint8_t>& turn_a, stream<lanes_t<Count> >& out_a, stream<uint8_t>& flags_a,
                stream<uint8_t>& turn_b, stream<lanes_t<Count> >& out_b, stream<uint8_t>& flags_b,
                uint16_t width, uint16_t height) {
  const int pixels =
      Config::columns(width, geometry::base_level) * Config::rows(height, geometry::base_level);
  const uint8_t whose = Turn<Config, Count, Kind>::next;
  Turn<Config, Count, Kind>::next = static_cast<uint8_t>(1 - whose);
  turn.write(whose);
  turn_a.write(whose);
  turn_b.write(whose);
#pragma nounroll
  for (int i = 0; i < pixels; ++i) {
    SAILMAP_PIPELINE
    const lanes_t<Count> word = in.read();
    const uint8_t flags = in_flags.read();
    if (whose == 0) {
      out_a.write(word);
      flags_a.write(flags);
    } else {
      out_b.write(word);
      flags_b.write(flags);
    }
  }
}

template <class Config, int Count, int Kind, int Bank>
void store_in_turn(stream<uint8_t>& turn, stream<lanes_t<Count> >& in, stream<uint8_t>& in_flags,
                   stream<uint32_t>& statistics, stream<lanes_t<Count> >& maps_out,
                   stream<lanes_t<Count> >& out, uint16_t width, uint16_t height) {
  if (turn.read() == Bank)
    store<Config, Count, Kind, Bank>(in, in_flags, statistics, maps_out, out, width, height);
}

// One store's frame handed on.
template <class Config, int Count, int Kind>
SAILMAP_INLINED void hand_on(stream<uint32_t>& statistics_in, stream<lanes_t<Count> >& maps_in,
                             stream<lanes_t<Count> >& in, stream<uint32_t>& statistics,
                             stream<lanes_t<Count> >& maps_out, stream<lanes_t<Count> >& out, int pixels) {
#pragma nounroll
  for (int i = Kind; i < 2 * Count + Kind; ++i) statistics.write(statistics_in.read());
#pragma nounroll
  for (int i = Kind; i < pixels + Kind; ++i) {
    SAILMAP_PIPELINE
    maps_out.write(maps_in.read());
    out.write(in.read());
  }
#pragma nounroll
  for (int i = Kind; i < (passes - 1) * pixels + Kind; ++i) {
    SAILMAP_PIPELINE
    out.write(in.read());
  }
}

// Each store has loops of its own: of reads of either stream under a condition Bambu's compiler makes reads
// of one of them.
template <class Config, int Count, int Kind>
void collect_turns(stream<uint8_t>& turn, stream<uint32_t>& statistics_a, stream<lanes_t<Count> >& maps_a,
                   stream<lanes_t<Count> >& in_a, stream<uint32_t>& statistics_b,
                   stream<lanes_t<Count> >& maps_b, stream<lanes_t<Count> >& in_b,
                   stream<uint32_t>& statistics, stream<lanes_t<Count> >& maps_out,
                   stream<lanes_t<Count> >& out, uint16_t width, uint16_t height) {
  const int pixels =
      Config::columns(width, geometry::base_level) * Config::rows(height, geometry::base_level);
  if (turn.read() == 0) {
    hand_on<Config, Count, Kind>(statistics_a, maps_a, in_a, statistics, maps_out, out, pixels);
  } else {
    hand_on<Config, Count, Kind>(statistics_b, maps_b, in_b, statistics, maps_out, out, pixels);
  }
}

}  // namespace hls
}  // namespace sailmap
