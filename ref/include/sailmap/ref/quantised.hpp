// The arithmetic policy of the hardware: every named point rounded to its format in hls/formats.hpp,
// everything between two points exact (hls/ranges.hpp: no intermediate value needs more than the 53 bits of a
// double).
//
// Values are in multiples of their format's unit: intensity as s = r+g+b, in 765ths; contrasts in 21sts of
// that. The units cancel in eq. 1; `Point::unit()` gives the maps back in the spec's units.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "sailmap/hls/formats.hpp"
#include "sailmap/ref/gabor_filters.hpp"

namespace sailmap::ref {

struct Quantised {
  static constexpr double tie = 0;  // integers are equal or not
  // The common denominator of 48 and 224 is 672 = 32 * 21, of which 21 is in the unit.
  static constexpr double contrast_divisor = 32;

  static double intensity(int s) { return s; }

  // The multiple of 2^-fraction that the format's rounding picks. Throws std::range_error when it does not
  // fit the word, which hls/ranges.hpp proves never to happen.
  template <class Point>
  static double at(double value) {
    static_assert(Point::rounding == hls::Rounding::rnd || Point::rounding == hls::Rounding::trn);
    constexpr double half = Point::rounding == hls::Rounding::rnd ? 0.5 : 0;
    constexpr auto least = static_cast<double>(Point::min_raw());
    constexpr auto largest = static_cast<double>(Point::max_raw());
    constexpr double scale = power_of_two(Point::fraction);
    constexpr double lsb = power_of_two(-Point::fraction);
    const double raw = floor_of(value * scale + half);
    if constexpr (Point::overflow == hls::Overflow::sat) return std::clamp(raw, least, largest) * lsb;
    if (raw < least || raw > largest) {
      throw std::range_error(std::string(Point::name()) + ": " + std::to_string(value) + " does not fit");
    }
    return raw * lsb;
  }

  static GaborFilters gabor_filters() { return integer_gabor_filters(); }

  // 1 / (max sqrt(m)) as a block-floating number, 0 for a flat zero map: the root and the gain are rounded
  // after scaling to the places of their leading bits, so that dark images keep their relative precision.
  static double gain(double maximum, int maxima) {
    if (maximum <= 0) return 0;
    const double exact_root = std::sqrt(maxima);
    const int root_place = std::ilogb(exact_root);
    const double root =
        std::ldexp(at<hls::formats::square_root>(std::ldexp(exact_root, -root_place)), root_place);
    const int place = std::ilogb(maximum) + root_place;
    return std::ldexp(at<hls::formats::gain>(std::ldexp(1 / (maximum * root), place)), -place);
  }

 private:
  // std::floor of what an int64_t holds; many times as fast where the processor's own rounding may not be
  // assumed.
  static double floor_of(double value) {
    const auto towards_zero = static_cast<double>(static_cast<std::int64_t>(value));
    return towards_zero > value ? towards_zero - 1 : towards_zero;
  }
  static constexpr double power_of_two(int exponent) {
    double value = 1;
    for (int i = 0; i < exponent; ++i) value *= 2;
    for (int i = 0; i > exponent; --i) value /= 2;
    return value;
  }
};

}  // namespace sailmap::ref
