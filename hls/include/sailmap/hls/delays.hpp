// How long the delay lines are, in rows and columns: a formula of the geometry.
//
// In pixels of a level l; lags count from the arrival of the pyramid pixel.
// - The Gabor stage is ready 4 rows and 4 columns after a pixel, the centre-surround stage 7 and 7, and each
//   some turns later, in which it works side by side on columns that follow each other. The intensity goes
//   into Gabor 3 rows and 2 columns late, so that all maps of a level come in step.
// - Row k of level l+1 exists when row 2k+2 of level l has been read, and its sum is ready
//   sum_lag_rows(l+1) rows of level l+1 later. The row y = 2k-1 of the interpolated sum needs row k. So the
//   sum for row y is ready with row 2(k + sum_lag_rows(l+1)) + 2 = y + 2 sum_lag_rows(l+1) + 3 of level l:
//   the lag of level l. What the level's own contrast stage lags by itself is taken off: the rest is the
//   delay of its branch. With columns it is the same, but that the interpolation waits for the second of its
//   two coarse columns.
// A row more or less stops the network at depth 2 (testbench/csim/network_test.cpp).
#pragma once

#include "sailmap/hls/geometry.hpp"

namespace sailmap {
namespace hls {

// Turns from a pixel to the output that it is the newest column of: centre_surround.hpp (column sums, window
// sums, contrasts) and gabor.hpp (rows, vertical sums, window, energies).
constexpr int surround_turns = 3;
constexpr int gabor_turns = 4;
constexpr int surround_lag_columns = geometry::surround_radius_large + surround_turns;
constexpr int gabor_lag_columns = geometry::gabor_radius + gabor_turns;

// Rows of level `level` between a pyramid row and the across-scales sum of that row.
constexpr int sum_lag_rows(int level) {
  return level == geometry::top_level ? geometry::surround_radius_large : 2 * sum_lag_rows(level + 1) + 3;
}
// The same for columns within a row: a decimation waits for 2 columns, an interpolation for one coarse one.
constexpr int sum_lag_columns(int level) {
  return level == geometry::top_level ? surround_lag_columns : 2 * sum_lag_columns(level + 1) + 4;
}

// The delay of the five pyramid channels of a level before its contrast stages.
template <int Level>
struct BranchDelay {
  static constexpr int rows = sum_lag_rows(Level) - geometry::surround_radius_large;
  static constexpr int columns = sum_lag_columns(Level) - surround_lag_columns;
};

// The further delay of the intensity before the Gabor stage.
struct GaborDelay {
  static constexpr int rows = geometry::surround_radius_large - geometry::gabor_radius;
  static constexpr int columns = surround_lag_columns - gabor_lag_columns;
};

}  // namespace hls
}  // namespace sailmap
