#include "largest.hpp"

namespace sailmap::csim {

template std::vector<FrontEndWords> run_front_end<Largest<4>>(std::span<const Frame>, Scheduler&);

}  // namespace sailmap::csim
