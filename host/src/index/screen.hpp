// Screening: from the coarse codes of 64 images at a time, which of them can be at least as similar to the
// query as a threshold. Never says no where the similarity of eq. 7 would reach it.
//
// Why that is safe. Of the regions of the query, each that matches does so at no less than the least lower
// bound over all candidates that may be admissible. The k regions of MR thus cost at least the k smallest of
// these bounds, S_k: Sim <= k / S_k (`paper`) and Sim <= k^2 / (n S_k) (`paper_weighted`, n regions in the
// query), whatever subset constraint 2 leaves. An image for which S_k is above the limit for every k is out.
// As S_k is at least k S_1, it is the one smallest bound that decides for `paper`.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "region_code.hpp"
#include "sailmap/similarity.hpp"
#include "simd/aligned_vector.hpp"

namespace sailmap::index {

inline constexpr std::size_t block_images = 64;
// Images that share the bounds of their columns: as many as the largest vectors hold.
inline constexpr std::size_t group_images = 32;
inline constexpr std::size_t block_groups = block_images / group_images;
// Rows of pairs of code bytes: of directions (the last with the byte that is nothing), then of positions.
inline constexpr std::size_t code_rows = code_bytes / 2;
inline constexpr std::size_t direction_rows = code_rows - 1;

// Of each slot of a group of images, the least and the greatest column. Slots beyond are not told apart.
struct Columns {
  static constexpr std::size_t slots = 32;
  std::array<std::uint8_t, slots> first;
  std::array<std::uint8_t, slots> last;

  Columns() { clear(); }
  void clear() {
    first.fill(255);
    last.fill(0);
  }
  void add(std::size_t slot, std::int8_t code) {
    if (slot >= slots) return;
    const auto column = static_cast<std::uint8_t>(code + position_zero);
    first[slot] = std::min(first[slot], column);
    last[slot] = std::max(last[slot], column);
  }
  void add(const Columns& other) {
    for (std::size_t slot = 0; slot < slots; ++slot) {
      first[slot] = std::min(first[slot], other.first[slot]);
      last[slot] = std::max(last[slot], other.last[slot]);
    }
  }
};

// The codes of up to 64 images: for each slot (an image's regions in order of their column) five rows, one
// for each pair of code bytes, of 64 such pairs.
struct Block {
  AlignedVector<std::uint8_t> codes;
  std::array<Columns, block_groups> columns;
  std::array<std::int16_t, block_images> counts{};  // regions of each image, slots beyond are empty
  // What each image's regions share, see kinds_shared; no_shares also where positions are not exact.
  std::array<std::uint8_t, block_images> kinds{};
  bool exact_positions = true;

  static constexpr std::size_t row_bytes = 2 * block_images;
  static constexpr std::size_t slot_bytes = code_bytes * block_images;
  [[nodiscard]] std::size_t slots() const { return codes.size() / slot_bytes; }
  // The signature can_be_bounded.
  void add(std::size_t lane, const Signature& signature);
  [[nodiscard]] std::size_t memory() const;  // bytes, without the block itself
};

using SortingNetwork = std::vector<std::pair<std::uint16_t, std::uint16_t>>;

// Pairs (i, j), i < j, whose comparisons in this order sort `size` numbers (Batcher's odd-even merge).
SortingNetwork sorting_network(std::size_t size);

// One region of the query, as the kernel wants it: in 16 bits, modulo 2^16 on the way. With a candidate's
// code c and the query's q in half steps, the squared distance is |c|^2 - q.c + |q|^2/4, rounded down. With
// positions c and q, half the squared offset is |c|^2/2 - q.c + |q|^2/2, halves rounded down. Of two bytes
// multiplied one has to be unsigned: that is q, counted from -128 (directions) and -position_zero; what this
// adds to q.c is a matter of the candidate alone.
struct ScreenRegion {
  std::array<std::int16_t, code_rows> pairs{};  // q in unsigned bytes, two in each
  std::int16_t descriptor_rest = 0;             // |q|^2/4
  // Constraint 1 fails for certain where half the squared offset, less |q|^2/2 and the bias, is this or more:
  // among exact positions, and among others.
  std::array<std::int16_t, 2> position_limits{};
  float error = 0;  // of both codes, in distance codes
  // Squared distance of a candidate that reaches the threshold by itself (`paper`): this at most.
  std::uint16_t squared_limit = 0;
  std::uint8_t first_column = 0;  // that may hold admissible candidates
  std::uint8_t last_column = 0;
};

// `radius` of constraint 1 in pixels.
ScreenRegion screen_region(const Region& region, const PositionGrid& grid, double radius);

// The regions by column, which is the order of the slots and of the query's regions.
std::vector<const Region*> by_column(const Signature& signature);

// What screening knows of the query.
class ScreenQuery {
 public:
  // The query has at least one region and can_be_bounded.
  ScreenQuery(const Signature& query, const MatchConfig& config);

  // From now on asks for similarities of at least `threshold` > 0.
  void set_threshold(double threshold);

  // A bit for each image that may reach the threshold.
  [[nodiscard]] std::uint64_t passing(const Block& block) { return passing(block, block); }
  // `next` will be asked about next: its codes are fetched from memory meanwhile.
  [[nodiscard]] std::uint64_t passing(const Block& block, const Block& next);

  // For the kernel.
  bool one_is_enough = false;         // of the least bounds: `squared_limit` instead of all below
  std::vector<ScreenRegion> regions;  // by column
  bool exact_positions = true;        // of the query
  float scale = 0;                    // distance codes (0 .. 255) in a step
  std::vector<std::uint16_t> limits;  // of S_k, k = 1, 2, ..., in distance codes
  SortingNetwork network;

 private:
  void set_squared_limits(double threshold);
  void set_limits(double threshold);

  std::vector<double> errors_;  // of the codes of `regions`
  AlignedVector<std::uint8_t> work_;
};

}  // namespace sailmap::index
