// The front end for frames of any size; each beat is compiled in a file of its own.
#pragma once

#include "sailmap/csim/front_end.hpp"
#include "sailmap/hls/config.hpp"

namespace sailmap::csim {

template <int Beat>
using Largest = hls::Config<hls::geometry::max_image_side, hls::geometry::max_image_side, Beat>;

}  // namespace sailmap::csim
