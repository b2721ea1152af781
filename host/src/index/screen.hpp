// Screening: from the coarse codes of 64 images at a time, which of them can be at least as similar to the
// query as a threshold. Never says no where the similarity of eq. 7 would reach it.
//
// Why that is safe. Of the regions of the query, each that matches does so at no less than the least lower
// bound over all candidates that may be admissible. The k regions of MR thus cost at least the k smallest of
// these bounds, S_k: Sim <= k / S_k (`paper`) and Sim <= k^2 / (n S_k) (`paper_weighted`, n regions in the
// query), whatever subset constraint 2 leaves. An image for which S_k is above the limit for every k is out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "region_code.hpp"
#include "sailmap/similarity.hpp"

namespace sailmap::index {

inline constexpr std::size_t block_images = 64;

// The codes of up to 64 images: for each slot (the images' regions in order of their column) `code_bytes`
// rows of 64 bytes.
struct Block {
  std::vector<std::uint8_t> codes;
  struct Columns {
    std::uint8_t first = no_cell;
    std::uint8_t last = 0;
  };
  std::vector<Columns> columns;  // of each slot, over its images

  [[nodiscard]] std::size_t slots() const { return columns.size(); }
  void add(std::size_t lane, const Signature& signature);
  [[nodiscard]] std::size_t memory() const;
};

// Pairs (i, j), i < j, whose comparisons in this order sort `size` numbers (Batcher's odd-even merge).
std::vector<std::pair<std::uint16_t, std::uint16_t>> sorting_network(std::size_t size);

// The largest similarity k / S_k or k^2 / (n S_k) over all k, given the distances in rising order.
double similarity_bound(const float* rising, std::size_t count, Method method, std::size_t regions);

// What screening knows of the query: for each region and each of the eight code numbers a table over its
// sixteen values. Those of the directions add up, saturating, to a lower bound of the squared distance, those
// of column and row to 128 or more where constraint 1 fails for certain.
class ScreenQuery {
 public:
  // The query has at least one region and can_be_bounded.
  ScreenQuery(const Signature& query, const MatchConfig& config);

  // From now on asks for similarities of at least `threshold` > 0.
  void set_threshold(double threshold);

  // A bit for each image that passes.
  [[nodiscard]] std::uint64_t passing(const Block& block);

  using Tables = std::array<std::array<std::uint8_t, levels>, code_numbers>;
  struct Columns {
    std::uint8_t first = 0;
    std::uint8_t last = 0;
  };

  // For the kernel.
  std::vector<Tables> tables;            // by query region
  std::vector<Columns> columns;          // that may hold admissible candidates
  std::vector<std::uint16_t> limits;     // of S_k, k = 1, 2, ..., in units of the distance codes
  std::array<std::uint8_t, 48> roots{};  // distance codes: see set_scale
  std::vector<std::pair<std::uint16_t, std::uint16_t>> network;
  std::vector<std::uint8_t> work;

 private:
  void set_scale(double clip);

  Method method_;
  std::vector<Projection> projections_;
  double clip_ = 0;  // the distance from which on all count the same
};

// The query's regions in columns of single-precision numbers, padded to a whole number of vectors.
struct QueryLanes {
  std::size_t count = 0;
  std::vector<float> x, y;
  std::array<std::vector<float>, feature_count> descriptor;
  float squared_radius = 0;  // rounded up
};
QueryLanes make_lanes(const Signature& query, const MatchConfig& config);

// The largest similarity that the nearest distances allow (constraint 1, but not 2), in single precision,
// rounded up.
class NearestBound {
 public:
  NearestBound(const Signature& query, const MatchConfig& config);
  [[nodiscard]] double operator()(const Signature& candidate);

 private:
  Method method_;
  QueryLanes lanes_;
  std::vector<std::pair<std::uint16_t, std::uint16_t>> network_;
  std::vector<float> nearest_;
};

}  // namespace sailmap::index
