// Highway's targets whose vectors have a size: to be included before foreach_target.h.
#pragma once

// Kernels keep vectors in arrays and structs and pack by 128-bit blocks, which vectors of a size unknown to
// the compiler do not do.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
