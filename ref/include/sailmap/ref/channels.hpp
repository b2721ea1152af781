// Spec section 2: intensity and the four broadly tuned colour channels of an RGB image.
#pragma once

#include <algorithm>
#include <array>

#include "sailmap/ref/plane.hpp"
#include "sailmap/ref/policy.hpp"

namespace sailmap::ref {

struct Channels {
  Plane<double> intensity;  // I in [0, 1]
  Plane<double> red;        // R, G, B in [0, 3]
  Plane<double> green;
  Plane<double> blue;
  Plane<double> yellow;  // Y in [0, 1.5]
};

// r' = 3r/s and so on, where s = r+g+b is above a tenth of full scale; elsewhere the colours are 0. With
// k = 3/(2s): R = r' - (g'+b')/2 = k(2r - g - b), and Y = (r'+g')/2 - |r'-g'|/2 - b' = min(r',g') - b' =
// k(2 min(r,g) - 2b), so one reciprocal a pixel serves all four.
template <class Policy>
Channels channels(const ImageView& image) {
  const int w = image.width;
  const int h = image.height;
  Channels out{Plane<double>(w, h), Plane<double>(w, h), Plane<double>(w, h), Plane<double>(w, h),
               Plane<double>(w, h)};
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      const auto [r, g, b] = image.at(x, y);
      const int s = r + g + b;
      out.intensity(x, y) = Policy::template at<point::grey_sum>(Policy::intensity(s));
      if (10 * s <= 765) continue;
      const double k = Policy::template at<point::colour_reciprocal>(1.5 / s);
      const auto tuned = [k](int doubled) {
        return Policy::template at<point::colour>(k * std::max(doubled, 0));
      };
      out.red(x, y) = tuned(2 * r - g - b);
      out.green(x, y) = tuned(2 * g - r - b);
      out.blue(x, y) = tuned(2 * b - r - g);
      out.yellow(x, y) = tuned(2 * std::min(r, g) - 2 * b);
    }
  }
  return out;
}

}  // namespace sailmap::ref
