// Highway, for the targets that the kernels are written for: to be included before foreach_target.h.
#pragma once

#include "simd/sized_vectors.hpp"

// The fallback is 128 bits in plain C++, which Highway does without where the compiler's vectorizer
// miscompiles it (GCC bug 106322): these files are compiled without that.
#define HWY_BROKEN_EMU128 0
