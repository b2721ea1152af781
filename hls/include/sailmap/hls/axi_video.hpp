// AMD wrapper stages: AXI4-Stream video in, AXI4-Stream maps out. For Vitis alone; ap_axiu appears nowhere
// else.
//
// Video in (UG934): one beat carries Config::beat pixels, the left one lowest, each {R, B, G} from high to
// low byte. TUSER marks the first beat of a frame, TLAST the last of a line. Every frame that starts makes
// one frame of maps, so that what follows stays in step; a faulty one is filled up with black, or cut, and
// counted:
//   short line    TLAST too early: the rest of the line is black
//   long line     no TLAST where it is due: the line is cut
//   short frame   a new frame starts too early: the rest is black, and the new frame is taken next, complete
//   long frame    lines after the last one: dropped
//   missing start a frame's worth of lines without TUSER, or beats before the first frame: dropped
// Maps out: TUSER on the first word of a frame, TLAST on the last of each row (statistics: of each frame).
// Latency 0. II 1.
#pragma once

#include <ap_axi_sdata.h>

#include <cstdint>

#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/normalise.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

template <int Beat>
using video_beat = ap_axiu<24 * Beat, 1, 1, 1>;
template <int Bits>
using map_beat = ap_axiu<Bits, 1, 1, 1>;

// The words of the status register. All count since reset.
namespace status {
constexpr int frames = 0;  // frames taken, good and bad
constexpr int bad_frames = 1;
constexpr int short_lines = 2;
constexpr int long_lines = 3;
constexpr int short_frames = 4;
constexpr int long_frames = 5;
constexpr int missing_starts = 6;
constexpr int refused = 7;  // starts with a size that Config does not take
constexpr int words = 8;
}  // namespace status

// Byte `Component` (0 green, 1 blue, 2 red) of each pixel of a beat.
template <int Beat, int Component>
inline bytes_t<Beat> video_component(const video_beat<Beat>& beat) {
  uint64_t word = 0;
  for (int i = 0; i < Beat; ++i) {
    const uint64_t byte = beat.data.range(24 * i + 8 * Component + 7, 24 * i + 8 * Component).to_uint();
    word |= byte << (8 * i);
  }
  return static_cast<bytes_t<Beat> >(word);
}

template <class Config>
struct VideoState {
  static bool any;      // a frame has been taken
  static bool pending;  // `start` is the first beat of the next frame
  static video_beat<Config::beat> start;
  static uint32_t counts[status::words];
};
template <class Config>
bool VideoState<Config>::any = false;
template <class Config>
bool VideoState<Config>::pending = false;
template <class Config>
video_beat<Config::beat> VideoState<Config>::start;
template <class Config>
uint32_t VideoState<Config>::counts[status::words] = {0, 0, 0, 0, 0, 0, 0, 0};

// Reads until a frame starts; returns its first beat.
template <class Config>
inline video_beat<Config::beat> find_start(stream<video_beat<Config::beat> >& video, uint16_t height) {
  using State = VideoState<Config>;
  video_beat<Config::beat> beat = State::start;
  bool found = State::pending;
  State::pending = false;
  bool dropped = false;
  uint16_t lines = 0;
  while (!found) {
    SAILMAP_PIPELINE
    beat = video.read();
    found = beat.user.to_uint() != 0;
    if (!found) {
      dropped = true;
      if (beat.last.to_uint() != 0) ++lines;
      if (lines == height) {
        ++State::counts[status::missing_starts];
        dropped = false;
        lines = 0;
      }
    }
  }
  if (dropped) ++State::counts[State::any ? status::long_frames : status::missing_starts];
  State::any = true;
  return beat;
}

// Where the reading of one frame stands.
template <class Config>
struct FrameReader {
  using State = VideoState<Config>;
  using Beat = video_beat<Config::beat>;

  Beat beat;        // the last one read
  bool unused;      // `beat` is the next one of the frame
  bool line_over;   // the rest of the line is black
  bool frame_over;  // so is the rest of the frame: the next one has started
  bool bad;

  void count(int fault) {
    ++State::counts[fault];
    bad = true;
  }
  // `beat` starts the next frame too early: keep it for then.
  void keep_for_next() {
    State::start = beat;
    State::pending = true;
    frame_over = true;
    line_over = true;
  }
  void read(stream<Beat>& video) {
    if (line_over || unused) {
      unused = false;
      return;
    }
    beat = video.read();
    if (beat.user.to_uint() != 0) {
      count(status::short_frames);
      keep_for_next();
    }
  }
  // After the beat has been used; `due` says that it is the last of its line.
  void end_beat(bool due) {
    if (line_over || beat.last.to_uint() == 0) return;
    if (!due) count(status::short_lines);
    line_over = true;
  }
  // Drops what is beyond the width; `last` says that it is the last line.
  void end_line(stream<Beat>& video, bool last) {
    if (!line_over) count(status::long_lines);
    while (!line_over) {
      SAILMAP_PIPELINE
      beat = video.read();
      line_over = beat.last.to_uint() != 0;
      if (beat.user.to_uint() != 0) {
        if (!last) count(status::short_frames);
        keep_for_next();
      }
    }
  }
};

// One frame to the front end.
template <class Config>
void video_in(stream<video_beat<Config::beat> >& video, stream<bytes_t<Config::beat> >& red,
              stream<bytes_t<Config::beat> >& green, stream<bytes_t<Config::beat> >& blue,
              uint32_t* status_out, uint16_t width, uint16_t height) {
  using State = VideoState<Config>;
  using Pixels = bytes_t<Config::beat>;
  const int beats = width / Config::beat;
  FrameReader<Config> frame = {find_start<Config>(video, height), true, false, false, false};
  for (int y = 0; y < height; ++y) {
    frame.line_over = frame.frame_over;
    for (int x = 0; x < beats; ++x) {
      SAILMAP_PIPELINE
      frame.read(video);
      red.write(frame.line_over ? Pixels(0) : video_component<Config::beat, 2>(frame.beat));
      green.write(frame.line_over ? Pixels(0) : video_component<Config::beat, 0>(frame.beat));
      blue.write(frame.line_over ? Pixels(0) : video_component<Config::beat, 1>(frame.beat));
      frame.end_beat(x + 1 == beats);
    }
    frame.end_line(video, y + 1 == height);
  }
  ++State::counts[status::frames];
  if (frame.bad) ++State::counts[status::bad_frames];
  for (int i = 0; i < status::refused; ++i) status_out[i] = State::counts[i];
}

// `rows` rows of `words` words, as AXI4-Stream packets.
template <int Bits, class Word>
inline void packets_out(stream<Word>& in, stream<map_beat<Bits> >& out, int words, int rows) {
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < words; ++x) {
      SAILMAP_PIPELINE
      map_beat<Bits> beat;
      beat.data = in.read();
      beat.keep = -1;
      beat.strb = -1;
      beat.user = x == 0 && y == 0 ? 1 : 0;
      beat.last = x + 1 == words ? 1 : 0;
      beat.id = 0;
      beat.dest = 0;
      out.write(beat);
    }
  }
}

// Port tells the instances apart.
template <class Config, int Port, class Word>
void maps_out(stream<Word>& in, stream<map_beat<8 * sizeof(Word)> >& out, uint16_t width, uint16_t height) {
  packets_out<8 * sizeof(Word)>(in, out, geometry::base_side(width), geometry::base_side(height));
}
template <class Config>
void statistics_out(stream<uint32_t>& in, stream<map_beat<32> >& out) {
  packets_out<32>(in, out, statistics_words, 1);
}

}  // namespace hls
}  // namespace sailmap
