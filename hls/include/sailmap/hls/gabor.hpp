// Orientation, spec section 5: Gabor energy of the intensity at 0, 45, 90 and 135 degrees.
//
// Streams, level `Level`, one pixel a word, raster order. In: intensity. Out: the four energies as two pairs.
// Formats: intensity in; gabor_column between the passes; gabor_energy out. Latency: 4 rows and 8 columns.
// II 1 on the base level, where a pixel has 4 or 16 of its pixels' time 4 or 16. Rows stand alone: a row
// takes 4 words of filling and 8 of flushing. Maximum error against the exact energies of the exact level:
// accuracy::gabor_level_error.
//
// Separable: five vertical filters on the raw pixels, then horizontal ones on their sums, of which the
// orientations share the products. The horizontal filters work on the columns of the turns before, side by
// side with the vertical ones of the newest column.
#pragma once

#include "sailmap/hls/arithmetic.hpp"
#include "sailmap/hls/delays.hpp"
#include "sailmap/hls/gabor_coefficients.hpp"
#include "sailmap/hls/geometry.hpp"
#include "sailmap/hls/lanes.hpp"
#include "sailmap/hls/pragmas.hpp"
#include "sailmap/hls/stream.hpp"

namespace sailmap {
namespace hls {

// The first column of a row stands for those before it: it goes in so much oftener.
constexpr int gabor_filling = geometry::gabor_radius;

// Nine numbers in a row or column, the oldest first.
struct NineTaps {
  int32_t a, b, c, d, e, f, g, h, i;
};

// A pixel or a column sum, for which 17 bits are enough.
inline int32_t few_bits(int32_t value) { return narrow_signed<17>(value); }

// Filters that read the same forwards and backwards, or change sign: half the multiplications. One
// piece of hardware works through them, in Bambu one a cycle (SAILMAP_SHARED); on the base level two, half of
// them each.
template <int Level, int Half>
SAILMAP_SHARED int32_t gabor_filter(uint32_t kind, int16_t t0, int16_t t1, int16_t t2, int16_t t3, int16_t t4,
                                    int32_t a, int32_t b, int32_t c, int32_t d, int32_t e, int32_t f,
                                    int32_t g, int32_t h, int32_t i) {
  const bool antisymmetric = (untagged<2 * Level + Half>(kind) & 1U) != 0;
  const int32_t far4 = few_bits(antisymmetric ? -i : i);
  const int32_t far3 = few_bits(antisymmetric ? -h : h);
  const int32_t far2 = few_bits(antisymmetric ? -g : g);
  const int32_t far1 = few_bits(antisymmetric ? -f : f);
  return t0 * (few_bits(a) + far4) + t1 * (few_bits(b) + far3) + t2 * (few_bits(c) + far2) +
         t3 * (few_bits(d) + far1) + t4 * few_bits(e);
}

template <int Level, int Number>
struct GaborFilter {
  static constexpr int Half = Level == geometry::base_level ? Number : 0;

  static int32_t symmetric(const int (&taps)[gabor::taps], const NineTaps& p) {
    return gabor_filter<Level, Half>(tagged<2 * Level + Half>(0), static_cast<int16_t>(taps[0]),
                                     static_cast<int16_t>(taps[1]), static_cast<int16_t>(taps[2]),
                                     static_cast<int16_t>(taps[3]), static_cast<int16_t>(taps[4]), p.a, p.b,
                                     p.c, p.d, p.e, p.f, p.g, p.h, p.i);
  }
  static int32_t antisymmetric(const int (&taps)[gabor::taps], const NineTaps& p) {
    return gabor_filter<Level, Half>(tagged<2 * Level + Half>(1), static_cast<int16_t>(taps[0]),
                                     static_cast<int16_t>(taps[1]), static_cast<int16_t>(taps[2]),
                                     static_cast<int16_t>(taps[3]), 0, p.a, p.b, p.c, p.d, p.e, p.f, p.g, p.h,
                                     p.i);
  }
};

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
// The eight rows above the newest, packed: lane 0 of `newer` is the last row, lane 3 of `older` the eighth
// before. One word more than columns, for turns without a new one.
template <class Config, int Level>
struct GaborRows {
  static constexpr int none = Config::level_width(Level);
  static uint64_t newer[Config::level_width(Level) + 1];
  static uint64_t older[Config::level_width(Level) + 1];
};
template <class Config, int Level>
SAILMAP_MEMORY uint64_t GaborRows<Config, Level>::newer[Config::level_width(Level) + 1];
template <class Config, int Level>
SAILMAP_MEMORY uint64_t GaborRows<Config, Level>::older[Config::level_width(Level) + 1];

// Takes in a pixel of column x of the first rows, before anything comes out; the first row stands for all
// above it.
template <class Config, int Level>
inline void keep_row(uint16_t newest, int x, bool first) {
  uint64_t* const newer = GaborRows<Config, Level>::newer;
  uint64_t* const older = GaborRows<Config, Level>::older;
  const uint64_t replicated = pack(newest, newest, newest, newest);
  const uint64_t above = first ? replicated : newer[x];
  const uint64_t far_above = first ? replicated : older[x];
  newer[x] = above << lane_bits | newest;
  older[x] = far_above << lane_bits | lane<3>(above);
}

// The vertical sums of one column: filters E, O, C, S and G.
struct GaborColumn {
  int32_t even, odd, cosine, sine, gauss;
};

// Nine rows of one column: the eight above packed as in GaborRows.
struct GaborTaps {
  uint64_t far_above, above;
  uint16_t newest;
};

// Takes in a pixel of column x, to be kept in column `to`: `read`, or where there is none, beyond the last
// row, that row again.
template <class Config, int Level>
inline GaborTaps gabor_taps(uint16_t read, bool is_read, int x, int to) {
  uint64_t* const newer = GaborRows<Config, Level>::newer;
  uint64_t* const older = GaborRows<Config, Level>::older;
  GaborTaps out = {older[x], newer[x], 0};
  out.newest = is_read ? read : lane<0>(out.above);
  newer[to] = out.above << lane_bits | out.newest;
  older[to] = out.far_above << lane_bits | lane<3>(out.above);
  return out;
}

template <int Level>
SAILMAP_INLINED GaborColumn gabor_column_of(const GaborTaps& taps) {
  using A = GaborFilter<Level, 0>;
  using B = GaborFilter<Level, 1>;
  NineTaps p = {0, 0, 0, 0, 0, 0, 0, 0, 0};
  p.a = lane<3>(taps.far_above);
  p.b = lane<2>(taps.far_above);
  p.c = lane<1>(taps.far_above);
  p.d = lane<0>(taps.far_above);
  p.e = lane<3>(taps.above);
  p.f = lane<2>(taps.above);
  p.g = lane<1>(taps.above);
  p.h = lane<0>(taps.above);
  p.i = taps.newest;
  GaborColumn out = {0, 0, 0, 0, 0};
  out.even = gabor_column(A::symmetric(gabor::E, p));
  out.odd = gabor_column(B::antisymmetric(gabor::O, p));
  out.cosine = gabor_column(A::symmetric(gabor::C, p));
  out.sine = gabor_column(B::antisymmetric(gabor::S, p));
  out.gauss = gabor_column(A::symmetric(gabor::G, p));
  return out;
}

// Nine columns of each vertical sum, as they run along a row.
struct GaborWindow {
  NineTaps even, odd, cosine, sine, gauss;

  void next(const GaborColumn& column) {
    shift_in(even, column.even);
    shift_in(odd, column.odd);
    shift_in(cosine, column.cosine);
    shift_in(sine, column.sine);
    shift_in(gauss, column.gauss);
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
template <int Level>
SAILMAP_INLINED GaborEnergies gabor_energies(const GaborWindow& w) {
  using A = GaborFilter<Level, 0>;
  using B = GaborFilter<Level, 1>;
  const int32_t cc = A::symmetric(gabor::C, w.cosine);
  const int32_t ss = B::antisymmetric(gabor::S, w.sine);
  const int32_t gg = A::symmetric(gabor::G, w.gauss);
  const int32_t sc = B::antisymmetric(gabor::S, w.cosine);
  const int32_t cs = A::symmetric(gabor::C, w.sine);
  const int32_t eg = B::symmetric(gabor::E, w.gauss);
  const int32_t og = A::antisymmetric(gabor::O, w.gauss);
  const int32_t ge = B::symmetric(gabor::G, w.even);
  const int32_t go = A::symmetric(gabor::G, w.odd);
  GaborEnergies out = {0, 0};
  out.ori_0_45 = wide_pair(energy(0, eg, og), energy(1, cc - ss - gg, sc + cs));
  out.ori_90_135 = wide_pair(energy(2, ge, go), energy(3, cc + ss - gg, cs - sc));
  return out;
}

template <class Config, int Level>
void orientation_energy(stream<uint16_t>& intensity, stream<uint64_t>& ori_0_45, stream<uint64_t>& ori_90_135,
                        uint16_t width, uint16_t height) {
  constexpr int radius = geometry::gabor_radius;
  constexpr int filling = gabor_filling;
  const int w = Config::columns(width, Level);
  const int h = Config::rows(height, Level);
#pragma nounroll
  for (int y = 0; y < radius; ++y) {
#pragma nounroll
    for (int x = 0; x < w; ++x) {
      SAILMAP_PIPELINE_II(geometry::area_ratio(Level))
      keep_row<Config, Level>(intensity.read(), x, y == 0);
    }
  }
  GaborTaps taps = {0, 0, 0};
  GaborColumn column = {0, 0, 0, 0, 0};
  GaborWindow window = GaborWindow();
  GaborEnergies energies = {0, 0};
#pragma nounroll
  for (int y = radius; y < h + radius; ++y) {
    // A bound rather than a condition that the whole row shares, of which a compiler makes two loops.
    const int end_of_reading = y < h ? filling + w : 0;
    int x = 0;
#pragma nounroll
    for (int i = 0; i < filling + w + radius + gabor_turns; ++i) {
      SAILMAP_PIPELINE_II(geometry::area_ratio(Level))
      const bool takes = i == 0 || (i > filling && i < filling + w);
      const bool reads = takes && i < end_of_reading;
      const bool writes = i >= filling + radius + gabor_turns;
      uint16_t read = 0;
      if (reads && writes) {
        ori_0_45.write(energies.ori_0_45);
        read = intensity.read();
        ori_90_135.write(energies.ori_90_135);
      } else if (reads) {
        read = intensity.read();
      } else if (writes) {
        ori_0_45.write(energies.ori_0_45);
        ori_90_135.write(energies.ori_90_135);
      }
      energies = gabor_energies<Level>(window);
      window.next(column);
      column = gabor_column_of<Level>(taps);
      const GaborTaps newest =
          gabor_taps<Config, Level>(read, reads, x, takes ? x : GaborRows<Config, Level>::none);
      taps.far_above = takes ? newest.far_above : taps.far_above;
      taps.above = takes ? newest.above : taps.above;
      taps.newest = takes ? newest.newest : taps.newest;
      x += takes ? 1 : 0;
    }
  }
}

}  // namespace hls
}  // namespace sailmap
