// Highway, for the targets that the kernels are written for: to be included before foreach_target.h.
#pragma once

// Kernels keep vectors in arrays and pack by 128-bit blocks, which vectors of unknown size do not do.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
// The fallback is 128 bits in plain C++, which Highway does without where the compiler's vectorizer
// miscompiles it (GCC bug 106322): these files are compiled without that.
#define HWY_BROKEN_EMU128 0
