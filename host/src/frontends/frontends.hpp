// The realisations behind make_frontend.
#pragma once

#include <memory>

#include "sailmap/frontend.hpp"

namespace sailmap {

std::unique_ptr<Frontend> make_fixed();
std::unique_ptr<Frontend> make_reference();
std::unique_ptr<Frontend> make_quantised();
std::unique_ptr<Frontend> make_csim();
std::unique_ptr<Frontend> make_xrt();

// Throws Error when a side is outside 64..4096 pixels (spec section 1).
void check_image_size(const ImageView& image);

}  // namespace sailmap
