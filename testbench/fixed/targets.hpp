// Every instruction set that the `fixed` front end is compiled for and this processor has.
#pragma once

// What vectors.hpp says of the instruction sets comes before highway.h.
// clang-format off
#include "frontends/fixed/vectors.hpp"
#include <hwy/highway.h>
// clang-format on

#include <cstdint>
#include <string>
#include <vector>

namespace sailmap::testing {

inline std::vector<std::int64_t> targets() {
  std::vector<std::int64_t> out;
  for (std::uint64_t left = static_cast<std::uint64_t>(hwy::SupportedTargets() & HWY_TARGETS); left != 0;
       left &= left - 1) {
    out.push_back(static_cast<std::int64_t>(left & -left));
  }
  return out;
}

// While it lives, kernels run with this instruction set.
class UseTarget {
 public:
  explicit UseTarget(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    update();
  }
  ~UseTarget() {
    hwy::SetSupportedTargetsForTest(0);
    update();
  }
  UseTarget(const UseTarget&) = delete;
  UseTarget& operator=(const UseTarget&) = delete;
  UseTarget(UseTarget&&) = delete;
  UseTarget& operator=(UseTarget&&) = delete;

 private:
  static void update() { hwy::GetChosenTarget().Update(hwy::SupportedTargets()); }
};

inline std::string name_of(std::int64_t target) { return hwy::TargetName(target); }

}  // namespace sailmap::testing
