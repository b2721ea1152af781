#include "largest.hpp"

namespace sailmap::csim {

SAILMAP_LARGEST(, 4);

}  // namespace sailmap::csim
