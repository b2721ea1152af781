// How many clock cycles a frame takes, predicted from the constants of the kernels: every loop at the II its
// header names, nothing lost between loops. What a tool adds is a few cycles a row (the depth of its
// pipelines), to be measured.
//
// A stage is `busy` so many cycles with a frame; frames follow each other as fast as the busiest stage
// allows. All sizes are of level 0.
#pragma once

#include "sailmap/hls/delays.hpp"
#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/signature_arithmetic.hpp"
#include "sailmap/hls/signature_record.hpp"

namespace sailmap {
namespace hls {
namespace throughput {

using geometry::level_side;

constexpr long cycles(int columns, int rows) { return static_cast<long>(columns) * rows; }
constexpr long longer(long a, long b) { return a > b ? a : b; }

// Words into the front end.
constexpr long input(int w, int h, int beat) { return cycles(w / beat, h); }

// One reduction from level `fine`: pixel by pixel (a first pixel, then two a column, and the last row again
// without input), or `count` pixels a word.
constexpr long reduce_pixels(int w, int h, int fine) {
  return cycles(1 + 2 * level_side(w, fine + 1), level_side(h, fine)) + level_side(w, fine + 1);
}
constexpr long reduce_lanes(int w, int h, int fine, int count) {
  return cycles(level_side(w, fine) / count, level_side(h, fine) + 1);
}

// All reductions before the base level, the longest of them.
constexpr long to_base(int w, int h, int beat) {
  return beat == 1   ? longer(reduce_pixels(w, h, 0), reduce_pixels(w, h, 1))
         : beat == 2 ? longer(reduce_lanes(w, h, 0, 2), reduce_pixels(w, h, 1))
                     : longer(reduce_lanes(w, h, 0, beat), reduce_lanes(w, h, 1, beat / 2));
}

template <int Level>
constexpr long delay_line(int w, int h) {
  return cycles(level_side(w, Level) + BranchDelay<Level>::columns,
                level_side(h, Level) + BranchDelay<Level>::rows);
}
constexpr long centre_surround(int w, int h, int level) {
  return cycles(geometry::surround_radius_large + level_side(w, level) + surround_lag_columns,
                level_side(h, level) + geometry::surround_radius_large);
}
constexpr long orientation_energy(int w, int h, int level) {
  return cycles(geometry::gabor_radius + level_side(w, level) + gabor_lag_columns,
                level_side(h, level) + geometry::gabor_radius);
}
constexpr long across_scales(int w, int h, int level) {
  return cycles(1 + level_side(w, level), level_side(h, level)) + level_side(w, level + 1);
}
constexpr long base_pixels(int w, int h) { return cycles(geometry::base_side(w), geometry::base_side(h)); }

// The stages of the base level before the stores, the longest of them; the coarser levels have a quarter of
// its pixels.
constexpr long base_level(int w, int h) {
  return longer(longer(delay_line<2>(w, h), centre_surround(w, h, 2)),
                longer(across_scales(w, h, 2), reduce_pixels(w, h, 2)));
}

// Conspicuity is computed in two passes, and between them the local maxima are counted, at most as many as
// there are.
constexpr long two_passes(int w, int h) {
  return 2 * base_pixels(w, h) + geometry::most_maxima(geometry::base_side(w), geometry::base_side(h));
}

// A store fills at the pace of its input, counts, and replays twice, the second time while it fills again.
// Two that take turns share the frames, and what comes behind them.
constexpr long store(int w, int h, long fill, bool double_buffer) {
  const long again = two_passes(w, h) - base_pixels(w, h);
  return double_buffer
             ? longer(longer(fill, two_passes(w, h)), (longer(fill, again) + 2 * base_pixels(w, h) + 1) / 2)
             : longer(fill, again) + 2 * base_pixels(w, h);
}

// Cycles from frame to frame.
constexpr long frame(int w, int h, int beat, bool double_buffer) {
  return store(w, h, longer(longer(input(w, h, beat), to_base(w, h, beat)), base_level(w, h)), double_buffer);
}

// Cycles from a frame's first pixel in to its last saliency out: the frame, the rows that the coarser levels
// lag behind, the count, and the two passes.
constexpr long latency(int w, int h, int beat) {
  return longer(longer(input(w, h, beat), to_base(w, h, beat)), base_level(w, h)) +
         cycles(geometry::base_side(w), sum_lag_rows(geometry::base_level)) + base_pixels(w, h) +
         two_passes(w, h);
}

// --- The signature, of so many regions: after the frame's last saliency ---

// A look at every row's peak, and the rows of the box suppressed and searched again, four pixels a word.
constexpr long signature_search(int w, int h, int regions, int side) {
  return regions * (geometry::base_side(h) + cycles((geometry::base_side(w) + 3) / 4, side));
}
// The pixels of the box, and a division an entry.
constexpr long signature_description(int regions, int side) {
  return regions * (cycles(side, side) + cycles(geometry::feature_maps, entry_turns));
}
constexpr long signature_after_frame(int w, int h, int regions, int side) {
  return signature_search(w, h, regions, side) + signature_description(regions, side) +
         signature_record::words;
}

// From frame to frame where a signature of 20 regions follows the front end: it is busy from the feature
// maps on, through both passes, to its record.
constexpr long frame_with_signature(int w, int h, int beat, bool double_buffer, int side) {
  return longer(frame(w, h, beat, double_buffer),
                two_passes(w, h) + signature_after_frame(w, h, signature_record::max_regions, side));
}

}  // namespace throughput
}  // namespace hls
}  // namespace sailmap
