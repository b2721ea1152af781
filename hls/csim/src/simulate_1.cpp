#include "largest.hpp"

namespace sailmap::csim {

SAILMAP_LARGEST(, 1);

}  // namespace sailmap::csim
