// After the first frame the front end allocates nothing. This program counts every operator new.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "numbers/images.hpp"
#include "sailmap/frontend.hpp"
#include "sailmap/signature.hpp"

namespace {
std::atomic<int> allocations = 0;

void* counted(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size); memory != nullptr) return memory;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace sailmap::testing {
namespace {

int allocations_of(Frontend& frontend, const RgbImage& image, Maps& maps) {
  const int before = allocations;
  frontend.compute(image.view(), maps);
  return allocations - before;
}

TEST(FixedAllocation, NoneAfterTheFirstFrame) {
  const auto fixed = make_frontend("fixed");
  const RgbImage first = noise(200, 150, 1);
  const RgbImage second = noise(200, 150, 2, 90);
  Maps maps;
  EXPECT_GT(allocations_of(*fixed, first, maps), 0);
  EXPECT_EQ(allocations_of(*fixed, second, maps), 0);
  EXPECT_EQ(allocations_of(*fixed, first, maps), 0);
}

TEST(FixedAllocation, NoneForFramesThatFitTheMemoryOfEarlierOnes) {
  const auto fixed = make_frontend("fixed");
  Maps maps;
  allocations_of(*fixed, noise(200, 150, 1), maps);
  const RgbImage smaller = noise(130, 101, 2);
  EXPECT_EQ(allocations_of(*fixed, smaller, maps), 0);
}

// The answer itself, the rows' maxima, the map that is inhibited and the list of peaks as it grows.
TEST(FixedAllocation, RegionsTakeAFewAllocationsWhateverTheSize) {
  const auto fixed = make_frontend("fixed");
  for (const int side : {128, 512}) {
    Maps maps;
    allocations_of(*fixed, noise(side, side, 1), maps);
    const int before = allocations;
    const Signature signature = make_signature(maps, {});
    EXPECT_LE(allocations - before, 4);
    EXPECT_FALSE(signature.regions.empty());
  }
}

}  // namespace
}  // namespace sailmap::testing
