// A similarity in single precision: right but for rounding, or known not to be.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sailmap/similarity.hpp"

namespace sailmap::index {

// The query's regions in columns of numbers, by falling x (near ones share a vector), padded to whole vectors
// with regions that are nowhere.
struct QueryLanes {
  std::size_t count = 0;
  std::vector<float> x, y;
  std::array<std::vector<float>, feature_count> descriptor;
  std::vector<std::size_t> order;  // lanes in the order of the query's regions
  struct Reach {
    int first = 0;
    int last = 0;
  };
  std::vector<Reach> reaches;        // of each eight lanes: columns that may hold admissible candidates
  float largest_squared_offset = 0;  // constraint 1: squared pixels, whole
  float largest_squared_spread = 0;  // constraint 2
};
inline constexpr std::size_t lane_padding = 8;

// What the kernel finds: MR and its distances, see similarity.hpp.
struct ConsistentMatches {
  int count = 0;
  float sum = 0;           // of their distances
  bool ambiguous = false;  // two candidates of a region were too near each other for single precision
};

// Memory of the kernel, kept from call to call.
struct EstimateWork {
  std::vector<float> numbers;
  std::vector<std::int32_t> pairs;  // x and y of the candidates
  std::vector<float> x, y;
};

class Estimator {
 public:
  Estimator(const Signature& query, const MatchConfig& config);

  // At least the similarity that match() says, and above it by no more than 0.02 % unless ambiguous, when it
  // is infinite. Both signatures can_be_bounded.
  [[nodiscard]] double operator()(const Signature& candidate);

 private:
  MatchConfig config_;
  QueryLanes lanes_;
  EstimateWork work_;
  bool exact_ = true;  // squared pixels up to the limits are whole numbers in single precision
};

}  // namespace sailmap::index
