// Spec section 7, eq. 2: conspicuity and saliency, worked by hand.
#include "sailmap/ref/saliency.hpp"

#include <gtest/gtest.h>

#include <array>

#include "planes.hpp"

namespace sailmap {
namespace {

using testing::is_zero;
using testing::plane_of;

TEST(Conspicuity, IsTheSumOfItsMaps) {
  const std::array<Plane<double>, 2> maps = {plane_of({{1, 0.5}, {0, 0}}), plane_of({{0, 0.25}, {0.125, 0}})};
  EXPECT_EQ((ref::conspicuity<ref::Exact, ref::point::colour_conspicuity>(maps)),
            plane_of({{1, 0.75}, {0.125, 0}}));
}

Plane<double> saliency(const std::array<Plane<double>, 3>& conspicuities) {
  std::array<MapStatistics, 3> statistics;
  for (std::size_t i = 0; i < 3; ++i) {
    statistics[i] = ref::statistics(conspicuities[i], ref::Exact::tie);
  }
  return ref::saliency<ref::Exact>(conspicuities, statistics);
}

TEST(Saliency, SumsTheConspicuitiesNormalisedOnceMore) {
  // The first has one maximum above half, the second four of equal height, the third is flat.
  const std::array<Plane<double>, 3> conspicuities = {plane_of({{4, 0, 1, 0, 0, 0, 0}}),
                                                      plane_of({{2, 0, 2, 0, 2, 0, 2}}), Plane<double>(7, 1)};
  EXPECT_EQ(saliency(conspicuities), plane_of({{1.5, 0, 0.75, 0, 0.5, 0, 0.5}}));
}

TEST(Saliency, OfZeroMapsIsZero) {
  const Plane<double> zero(6, 4);
  EXPECT_TRUE(is_zero(saliency({zero, zero, zero})));
}

}  // namespace
}  // namespace sailmap
