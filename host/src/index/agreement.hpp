// The second look at images that screening leaves: from the same codes, now under both constraints, 32 images
// at a time, which of them can be at least as similar to the query as a threshold. Never says no where the
// similarity of eq. 7 would reach it.
//
// Why that is safe. Codes bound each distance d from both sides: d - e and d + e, where d is the distance of
// the codes and e their errors (plus, above, what a sum of shares may differ, see largest_squared_rest). The
// nearest candidate of a region of the query is one of those whose lower bound is not above the least upper
// bound of all: its *alternatives*. A region with one alternative is *certain*: its displacement is known
// exactly, as positions are. The common displacement of MR is one of a region's alternatives, so each of them
// is tried: with it agree certain regions, counted exactly as match() does, and any of the *doubtful* ones
// may. MR is hence those certain ones, and some of the doubtful.
// - MR is the largest such set, so |MR| >= m, the most certain regions that agree with a certain one.
// - For a similarity of T/n (`paper_weighted`, n regions in the query) |MR|^2 >= T sum(d) over MR. A doubtful
//   region more raises |MR|^2 by 2|MR| >= 2m at least: taking all of them, each at no more than 2m/T, makes
//   |MR|^2 - T sum(d) no less. For T (`paper`) it is |MR| >= T sum(d), and 1/T is enough.
// So an image is out when for each displacement tried, C certain and D doubtful regions, either C + D < m or
// (C + D)^2 (`paper`: C + D) < T (the certain ones' least distances + the doubtful ones', these cut).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "screen.hpp"

namespace sailmap::index {

inline constexpr std::size_t batch_images = group_images;

// The codes of up to 32 images of any blocks, as a block has them.
struct Batch {
  AlignedVector<std::uint8_t> codes;
  Columns columns;  // those of the groups that the images are of
  std::array<std::int16_t, batch_images> counts{};
  std::size_t images = 0;

  static constexpr std::size_t row_bytes = 2 * batch_images;
  static constexpr std::size_t slot_bytes = code_rows * row_bytes;
  [[nodiscard]] std::size_t slots() const { return codes.size() / slot_bytes; }
  [[nodiscard]] bool full() const { return images == batch_images; }
  void add(const Block& block, std::size_t lane);
  void clear();
};

// One region of the query. Distances are in squared code steps, as in ScreenRegion, positions in grid steps.
struct AgreementRegion {
  ScreenRegion screen;
  std::int16_t place = 0;  // the codes of its column and row
  float error = 0;         // in code steps, of both codes
};

inline constexpr std::size_t alternatives_kept = 3;  // of a region
inline constexpr std::size_t most_extras = 6;  // alternatives beyond the first, of all regions of an image

// Memory of the kernel, kept from call to call.
struct AgreementWork {
  using Row = std::array<std::int16_t, batch_images>;
  struct Slot {
    alignas(64) Row square, place, beyond;
    Row squared, displacement;  // of the region looked at: no_distance where inadmissible
  };
  std::vector<Slot, CacheLineAllocator<Slot>> slots;
  // A region of the query and one of its alternatives in each of the images.
  struct Nearest {
    alignas(64) Row displacement;  // two signed bytes, columns and rows
    Row certain;                   // 1 or 0
    Row cost;                      // T times the least distance of a certain region, otherwise 0
    Row doubtful_cost;             // that of a doubtful one
    Row matched;                   // all bits or none
    Row agreeing;                  // C, once its displacement was tried
    Row sum;                       // of the costs of these
  };
  std::vector<Nearest, CacheLineAllocator<Nearest>> nearest;
  // Further alternatives: of `nearest` what a displacement has.
  std::array<Nearest, most_extras> extras;
};

// What is asked of each image.
class AgreementQuery {
 public:
  // Like ScreenQuery.
  AgreementQuery(const Signature& query, const MatchConfig& config);

  // Of an image that it says nothing about, anything is possible.
  [[nodiscard]] bool judges(const Block& block, std::size_t lane) const {
    return usable_ && block.kinds[lane] == kinds_;
  }

  // From now on asks for similarities of at least `threshold` > 0.
  void set_threshold(double threshold);

  // A bit for each image that may reach the threshold.
  [[nodiscard]] std::uint32_t passing(const Batch& batch);

  // For the kernel. Costs are in 1 / cost_unit.
  std::vector<AgreementRegion> regions;     // by column
  std::int16_t largest_squared_offset = 0;  // constraint 1, in grid steps: whole numbers, no more than these
  std::int16_t largest_squared_spread = 0;  // constraint 2
  float cost_of_step = 0;
  bool squared = false;  // |MR|^2 rather than |MR|
  std::uint16_t cost_unit = 0;

 private:
  bool usable_ = false;
  std::uint8_t kinds_ = no_shares;
  AgreementWork work_;
};

}  // namespace sailmap::index
