// The bits in which words differ, in every instruction set, and the layouts' agreement, cell by cell.
#include "context/differing_bits.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "host/index/each_target.hpp"
#include "sailmap/context.hpp"
#include "sailmap/place_descriptor.hpp"

namespace sailmap::context {
namespace {

using sailmap::testing::for_each_target;

TEST(DifferingBits, AreCountedAlikeInAllInstructionSets) {
  for_each_target([] {
    std::mt19937_64 random(1);
    for (const std::size_t lanes : {1U, 7U, 8U, 27U, 85U}) {
      constexpr std::size_t words = 10;
      BitRows rows(words, lanes);
      std::vector<std::uint64_t> query(words);
      for (std::size_t w = 0; w < words; ++w) {
        query[w] = random();
        for (std::size_t lane = 0; lane < lanes; ++lane) rows.set(w, lane, random(), random());
      }
      const auto which = static_cast<std::uint32_t>(random() % 1024);
      std::vector<std::uint64_t> counts(rows.lanes, 12345);
      differing_bits(query.data(), which, rows, counts.data());
      for (std::size_t lane = 0; lane < rows.lanes; ++lane) {
        std::uint64_t expected = 0;
        for (std::size_t w = 0; w < words; ++w) {
          if (((which >> w) & 1U) == 0) continue;
          for (int bit = 0; bit < 64; ++bit) {
            const std::uint64_t differ = query[w] ^ rows.words[w * rows.lanes + lane];
            expected += (differ & rows.masks[w * rows.lanes + lane]) >> bit & 1U;
          }
        }
        ASSERT_EQ(counts[lane], expected) << lane << " of " << lanes;
      }
    }
  });
}

Layout random_layout(std::mt19937_64& random) {
  Layout out;
  for (auto& column : out.words) column = {random(), random() & ((std::uint64_t{1} << 56) - 1)};
  return out;
}

bool cell(const Layout& layout, int x, int y, int map) {
  const int bit = 10 * y + map;
  return ((layout.words[static_cast<std::size_t>(x)][static_cast<std::size_t>(bit / 64)] >> (bit % 64)) &
          1U) != 0;
}

bool says_something(const Layout& layout, int map) {
  for (int x = 0; x < Layout::columns; ++x) {
    for (int y = 0; y < Layout::rows; ++y) {
      if (cell(layout, x, y, map)) return true;
    }
  }
  return false;
}

bool has_colour(const Layout& layout) {
  return says_something(layout, 2) || says_something(layout, 3) || says_something(layout, 4) ||
         says_something(layout, 5);
}

// From the definition: the most, over shifts by up to four columns and a row, of the part of the cells on
// both layouts that are the same, less the part of those that are not. Maps without a bit are not compared,
// and count against it where only one layout has them, unless they are the colours that a grey one lacks.
double agreement_by_cells(const Layout& query, const Layout& candidate) {
  std::vector<int> maps;
  int of_query = 0;
  int of_candidate = 0;
  const bool colours = has_colour(query) && has_colour(candidate);
  for (int map = 0; map < 10; ++map) {
    if (!colours && map >= 2 && map < 6) continue;
    const bool in_query = says_something(query, map);
    const bool in_candidate = says_something(candidate, map);
    of_query += in_query ? 1 : 0;
    of_candidate += in_candidate ? 1 : 0;
    if (in_query && in_candidate) maps.push_back(map);
  }
  if (maps.empty()) return 0;
  double best = -1;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -4; dx <= 4; ++dx) {
      int compared = 0;
      int differing = 0;
      for (int x = 0; x < Layout::columns; ++x) {
        for (int y = 0; y < Layout::rows; ++y) {
          if (x + dx < 0 || x + dx >= Layout::columns || y + dy < 0 || y + dy >= Layout::rows) continue;
          for (const int map : maps) {
            ++compared;
            differing += cell(query, x, y, map) != cell(candidate, x + dx, y + dy, map) ? 1 : 0;
          }
        }
      }
      best = std::max(best, 1 - 2.0 * differing / compared);
    }
  }
  return best * static_cast<double>(maps.size()) / std::sqrt(of_query * of_candidate);
}

void clear(Layout& layout, int map) {
  for (int y = 0; y < Layout::rows; ++y) {
    const int bit = 10 * y + map;
    for (auto& column : layout.words) {
      column[static_cast<std::size_t>(bit / 64)] &= ~(std::uint64_t{1} << (bit % 64));
    }
  }
}

TEST(LayoutAgreement, IsThatOfTheCells) {
  for_each_target([] {
    std::mt19937_64 random(2);
    for (int i = 0; i < 50; ++i) {
      const Layout query = random_layout(random);
      Layout candidate = random_layout(random);
      // Partly the query, moved aside.
      const auto moved = static_cast<std::size_t>(random() % 5);
      for (std::size_t x = 0; x + moved < 12; ++x) candidate.words[x + moved] = query.words[x];
      ASSERT_EQ(layout_agreement(query, candidate), agreement_by_cells(query, candidate));
    }
  });
}

TEST(LayoutAgreement, LeavesOutMapsThatSayNothing) {
  for_each_target([] {
    std::mt19937_64 random(3);
    for (int i = 0; i < 100; ++i) {
      Layout query = random_layout(random);
      Layout candidate = random_layout(random);
      for (int map = 0; map < 10; ++map) {
        if (random() % 4 == 0) clear(query, map);
        if (random() % 2 == 0) clear(candidate, map);
      }
      ASSERT_NEAR(layout_agreement(query, candidate), agreement_by_cells(query, candidate), 1e-6);
    }
    const Layout flat;
    EXPECT_EQ(layout_agreement(flat, random_layout(random)), 0);
    EXPECT_EQ(layout_agreement(random_layout(random), flat), 0);
    EXPECT_EQ(layout_agreement(flat, flat), 0);
  });
}

// The colours that an image has lost make no other place of it, nor any place more like it.
TEST(LayoutAgreement, OfAGreyImageIsThatOfItsOtherMaps) {
  std::mt19937_64 random(4);
  const Layout coloured = random_layout(random);
  const Layout other = random_layout(random);
  Layout grey = coloured;
  for (int map = 2; map < 6; ++map) clear(grey, map);
  Layout other_grey = other;
  for (int map = 2; map < 6; ++map) clear(other_grey, map);
  EXPECT_EQ(layout_agreement(grey, grey), 1);
  EXPECT_EQ(layout_agreement(grey, coloured), 1);
  EXPECT_EQ(layout_agreement(grey, other), layout_agreement(grey, other_grey));
  Layout flat_intensity = coloured;
  clear(flat_intensity, 0);
  clear(flat_intensity, 1);
  EXPECT_NEAR(layout_agreement(flat_intensity, coloured), std::sqrt(0.8), 1e-6);
}

}  // namespace
}  // namespace sailmap::context
