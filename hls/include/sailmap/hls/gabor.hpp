// Orientation, spec section 5: Gabor energy of the intensity at 0, 45, 90 and 135 degrees.
//
// Streams, level `Level`, one pixel a word, raster order. In: intensity. Out: the four energies as two pairs.
// Formats: intensity in; gabor_column between the passes; gabor_energy out. Latency: 4 rows and 4 columns.
// II 1. Rows stand alone: a row takes 4 words of flushing. Maximum error against the exact energies
// of the exact level: accuracy::gabor_level_error.
//
// Separable: five vertical filters on the raw pixels, then horizontal ones on their sums, of which the
// orientations share the products. All coefficients are small constants, so that multiplications are shifts
// and adds.
#pragma once

#include "sailmap/hls/arithmetic.hpp"
#include "sailmap/hls/gabor_coefficients.hpp"
#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

// Nine numbers in a row or column, the oldest first.
struct NineTaps {
  int32_t a, b, c, d, e, f, g, h, i;
};

// Filters that read the same forwards and backwards, or change sign: half the multiplications.
inline int32_t symmetric(const int (&taps)[gabor::taps], const NineTaps& p) {
  return taps[0] * (p.a + p.i) + taps[1] * (p.b + p.h) + taps[2] * (p.c + p.g) + taps[3] * (p.d + p.f) +
         taps[4] * p.e;
}
inline int32_t antisymmetric(const int (&taps)[gabor::taps], const NineTaps& p) {
  return taps[0] * (p.a - p.i) + taps[1] * (p.b - p.h) + taps[2] * (p.c - p.g) + taps[3] * (p.d - p.f);
}

inline void shift_in(NineTaps& taps, int32_t value) {
  taps.a = taps.b;
  taps.b = taps.c;
  taps.c = taps.d;
  taps.d = taps.e;
  taps.e = taps.f;
  taps.f = taps.g;
  taps.g = taps.h;
  taps.h = taps.i;
  taps.i = value;
}
inline void fill_all(NineTaps& taps, int32_t value) {
  taps.a = value;
  taps.b = value;
  taps.c = value;
  taps.d = value;
  taps.e = value;
  taps.f = value;
  taps.g = value;
  taps.h = value;
  taps.i = value;
}

// The eight rows above the newest, packed: lane 0 of `newer` is the last row, lane 3 of `older` the eighth
// before.
template <class Config, int Level>
struct GaborRows {
  static uint64_t newer[Config::level_width(Level)];
  static uint64_t older[Config::level_width(Level)];
};
template <class Config, int Level>
SAILMAP_MEMORY uint64_t GaborRows<Config, Level>::newer[Config::level_width(Level)];
template <class Config, int Level>
SAILMAP_MEMORY uint64_t GaborRows<Config, Level>::older[Config::level_width(Level)];

// The vertical sums of one column: filters E, O, C, S and G.
struct GaborColumn {
  int32_t even, odd, cosine, sine, gauss;
};

// Takes in a pixel of column x: `read`, or beyond the last row that row again.
template <class Config, int Level>
inline GaborColumn gabor_rows(uint16_t read, int x, int y, int h) {
  uint64_t* const newer = GaborRows<Config, Level>::newer;
  uint64_t* const older = GaborRows<Config, Level>::older;
  const uint64_t n = newer[x];
  const uint64_t o = older[x];
  const uint16_t newest = y < h ? read : lane<0>(n);
  const uint64_t replicated = pack(newest, newest, newest, newest);
  const uint64_t above = y == 0 ? replicated : n;
  const uint64_t far_above = y == 0 ? replicated : o;
  newer[x] = above << lane_bits | newest;
  older[x] = far_above << lane_bits | lane<3>(above);
  NineTaps p = {0, 0, 0, 0, 0, 0, 0, 0, 0};
  p.a = lane<3>(far_above);
  p.b = lane<2>(far_above);
  p.c = lane<1>(far_above);
  p.d = lane<0>(far_above);
  p.e = lane<3>(above);
  p.f = lane<2>(above);
  p.g = lane<1>(above);
  p.h = lane<0>(above);
  p.i = newest;
  GaborColumn out = {0, 0, 0, 0, 0};
  out.even = gabor_column(symmetric(gabor::E, p));
  out.odd = gabor_column(antisymmetric(gabor::O, p));
  out.cosine = gabor_column(symmetric(gabor::C, p));
  out.sine = gabor_column(antisymmetric(gabor::S, p));
  out.gauss = gabor_column(symmetric(gabor::G, p));
  return out;
}

// Nine columns of each vertical sum, as they run along a row.
struct GaborWindow {
  NineTaps even, odd, cosine, sine, gauss;

  void next(bool first, const GaborColumn& column) {
    if (first) {
      fill_all(even, column.even);
      fill_all(odd, column.odd);
      fill_all(cosine, column.cosine);
      fill_all(sine, column.sine);
      fill_all(gauss, column.gauss);
    } else {
      shift_in(even, column.even);
      shift_in(odd, column.odd);
      shift_in(cosine, column.cosine);
      shift_in(sine, column.sine);
      shift_in(gauss, column.gauss);
    }
  }
};

inline uint32_t energy(int orientation, int32_t even, int32_t odd) {
  return gabor_energy(orientation, gabor_response(even), gabor_response(odd));
}

// The four energies of a window, two pairs.
struct GaborEnergies {
  uint64_t ori_0_45, ori_90_135;
};

// The sums are named filter along x, filter along y.
inline GaborEnergies gabor_energies(const GaborWindow& w) {
  const int32_t cc = symmetric(gabor::C, w.cosine);
  const int32_t ss = antisymmetric(gabor::S, w.sine);
  const int32_t gg = symmetric(gabor::G, w.gauss);
  const int32_t sc = antisymmetric(gabor::S, w.cosine);
  const int32_t cs = symmetric(gabor::C, w.sine);
  GaborEnergies out = {0, 0};
  out.ori_0_45 = wide_pair(energy(0, symmetric(gabor::E, w.gauss), antisymmetric(gabor::O, w.gauss)),
                           energy(1, cc - ss - gg, sc + cs));
  out.ori_90_135 = wide_pair(energy(2, symmetric(gabor::G, w.even), symmetric(gabor::G, w.odd)),
                             energy(3, cc + ss - gg, cs - sc));
  return out;
}

template <class Config, int Level>
void orientation_energy(stream<uint16_t>& intensity, stream<uint64_t>& ori_0_45, stream<uint64_t>& ori_90_135,
                        uint16_t width, uint16_t height) {
  constexpr int radius = geometry::gabor_radius;
  const int w = Config::columns(width, Level);
  const int h = Config::rows(height, Level);
#pragma nounroll
  for (int y = 0; y < h + radius; ++y) {
    GaborColumn column = {0, 0, 0, 0, 0};
    GaborWindow window = GaborWindow();
#pragma nounroll
    for (int x = 0; x < w + radius; ++x) {
      SAILMAP_PIPELINE
      if (x < w) {
        uint16_t read = 0;
        if (y < h) read = intensity.read();
        column = gabor_rows<Config, Level>(read, x, y, h);
      }
      window.next(x == 0, column);
      if (y >= radius && x >= radius) {
        const GaborEnergies energies = gabor_energies(window);
        ori_0_45.write(energies.ori_0_45);
        ori_90_135.write(energies.ori_90_135);
      }
    }
  }
}

}  // namespace hls
}  // namespace sailmap
