#include "largest.hpp"

namespace sailmap::csim {

SAILMAP_LARGEST(, 8);

}  // namespace sailmap::csim
