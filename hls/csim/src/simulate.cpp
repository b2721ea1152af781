#include "sailmap/csim/simulate.hpp"

#include "largest.hpp"

namespace sailmap::csim {

std::mutex& one_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

std::vector<FrontEndWords> simulate(std::span<const Frame> frames, int beat, Scheduler& scheduler) {
  return with_largest(beat, [&]<class Config>(Config) { return run_front_end<Config>(frames, scheduler); });
}

}  // namespace sailmap::csim
