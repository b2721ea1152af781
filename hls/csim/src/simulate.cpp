#include "sailmap/csim/simulate.hpp"

#include <mutex>

#include "largest.hpp"

namespace sailmap::csim {

extern template std::vector<FrontEndWords> run_front_end<Largest<1>>(std::span<const Frame>, Scheduler&);
extern template std::vector<FrontEndWords> run_front_end<Largest<2>>(std::span<const Frame>, Scheduler&);
extern template std::vector<FrontEndWords> run_front_end<Largest<4>>(std::span<const Frame>, Scheduler&);
extern template std::vector<FrontEndWords> run_front_end<Largest<8>>(std::span<const Frame>, Scheduler&);

std::vector<FrontEndWords> simulate(std::span<const Frame> frames, int beat, Scheduler& scheduler) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  switch (beat) {
    case 1:
      return run_front_end<Largest<1>>(frames, scheduler);
    case 2:
      return run_front_end<Largest<2>>(frames, scheduler);
    case 4:
      return run_front_end<Largest<4>>(frames, scheduler);
    case 8:
      return run_front_end<Largest<8>>(frames, scheduler);
    default:
      throw std::invalid_argument("no front end takes " + std::to_string(beat) + " pixels a beat");
  }
}

}  // namespace sailmap::csim
