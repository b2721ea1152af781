// Spec section 2: intensity and the four broadly tuned colours of level 0, a row at a time.
#pragma once

#include <array>
#include <cstdint>

#include "sailmap/ref/plane.hpp"
#include "samples.hpp"

namespace sailmap::fixed {

// Row `y` of the image as samples, one row of `image.width` a channel: s less grey_bias, and the colours.
void channels(const ImageView& image, int y, const std::array<Sample*, channel_count>& rows);

}  // namespace sailmap::fixed
