// Integer 1-D filters whose products are the Gabor windows of spec section 5.
//
// With g the Gaussian of sigma 7/3, w = 2 pi/7 and v = w/sqrt(2), tap i at position i - 4:
//   E ~ g (cos w x - DC)    0 degrees: even = E(x) G(y),                          odd = O(x) G(y);  90
//   degrees: x, y swapped O ~ g sin w x          45 degrees: even = C(x) C(y) - S(x) S(y) - G(x) G(y),  odd =
//   S(x) C(y) + C(x) S(y) C ~ g cos v x         135 degrees: even = C(x) C(y) + S(x) S(y) - G(x) G(y),  odd =
//   C(x) S(y) - S(x) C(y) S ~ g sin v x G ~ g sum(C)/sum(g)
// C, S and G share one scale, E and O have their own. Every even window is free of DC in exact integers:
// sum(E) = 0 and sum(G) = sum(C). The scales were searched for those (coefficients to 12 bits) whose windows,
// scaled to unit sum of absolute values, lie closest to the exact ones: `max_window_error` in sum of absolute
// differences.
#pragma once

#include <cstdint>

#include "sailmap/hls/geometry.hpp"

namespace sailmap {
namespace hls {
namespace gabor {

constexpr int taps = geometry::gabor_taps;

constexpr int E[taps] = {-950, -1807, -946, 1897, 3612, 1897, -946, -1807, -950};
constexpr int O[taps] = {336, -639, -2273, -2401, 0, 2401, 2273, 639, -336};
constexpr int C[taps] = {-683, -516, 741, 2647, 3603, 2647, 741, -516, -683};
constexpr int S[taps] = {-470, -1490, -2383, -1949, 0, 1949, 2383, 1490, 470};
constexpr int G[taps] = {331, 630, 997, 1313, 1439, 1313, 997, 630, 331};

constexpr double max_window_error = 0.00022;

constexpr int sum(const int (&filter)[taps]) {
  int total = 0;
  for (int i = 0; i < taps; ++i) total += filter[i];
  return total;
}

constexpr int absolute(int value) { return value < 0 ? -value : value; }

// Sum of the positive taps: the largest output for an input in [0, 1]; of all taps without sign: twice that,
// free of DC.
constexpr int positive_sum(const int (&filter)[taps]) {
  int total = 0;
  for (int i = 0; i < taps; ++i) total += filter[i] > 0 ? filter[i] : 0;
  return total;
}
constexpr int negative_sum(const int (&filter)[taps]) { return positive_sum(filter) - sum(filter); }

static_assert(sum(E) == 0 && sum(O) == 0 && sum(S) == 0, "the filters are free of DC");
static_assert(sum(G) == sum(C), "the 45 and 135 degree even windows are free of DC");

// The 2-D windows in integers, for the reference and the scales. `orientation`: theta / 45 degrees; x right,
// y down.
constexpr int even(int orientation, int x, int y) {
  return orientation == 0   ? E[x] * G[y]
         : orientation == 1 ? C[x] * C[y] - S[x] * S[y] - G[x] * G[y]
         : orientation == 2 ? E[y] * G[x]
                            : C[x] * C[y] + S[x] * S[y] - G[x] * G[y];
}
constexpr int odd(int orientation, int x, int y) {
  return orientation == 0   ? O[x] * G[y]
         : orientation == 1 ? S[x] * C[y] + C[x] * S[y]
         : orientation == 2 ? O[y] * G[x]
                            : C[x] * S[y] - S[x] * C[y];
}

// Sums of absolute values of the windows, which section 5 divides by. 0 and 90 degrees have the same, 45 and
// 135 too.
constexpr std::int64_t even_scale(int orientation) {
  std::int64_t total = 0;
  for (int y = 0; y < taps; ++y) {
    for (int x = 0; x < taps; ++x) total += absolute(even(orientation, x, y));
  }
  return total;
}
constexpr std::int64_t odd_scale(int orientation) {
  std::int64_t total = 0;
  for (int y = 0; y < taps; ++y) {
    for (int x = 0; x < taps; ++x) total += absolute(odd(orientation, x, y));
  }
  return total;
}

static_assert(even_scale(0) == even_scale(2) && even_scale(1) == even_scale(3), "orientations pair up");
static_assert(odd_scale(0) == odd_scale(2) && odd_scale(1) == odd_scale(3), "orientations pair up");

}  // namespace gabor
}  // namespace hls
}  // namespace sailmap
