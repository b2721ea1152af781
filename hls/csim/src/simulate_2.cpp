#include "largest.hpp"

namespace sailmap::csim {

SAILMAP_LARGEST(, 2);

}  // namespace sailmap::csim
