// What holds for every ground truth that a reader returns.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

#include "foreign_file.hpp"
#include "sailmap/ground_truth.hpp"

namespace sailmap::fuzz {

inline void check_matches(const GroundTruth& truth, int queries, int candidates, bool same_sequence) {
  demand(truth.matches.size() == static_cast<std::size_t>(queries), "one row a query");
  for (std::size_t query = 0; query < truth.matches.size(); ++query) {
    const std::vector<int>& row = truth.matches[query];
    demand(std::ranges::adjacent_find(row, std::greater_equal<>{}) == row.end(), "candidates rise");
    if (row.empty()) continue;
    demand(row.front() >= 0 && row.back() < candidates, "candidates are images");
    const bool itself = std::ranges::binary_search(row, static_cast<int>(query));
    demand(!same_sequence || !itself, "no image matches itself");
  }
}

}  // namespace sailmap::fuzz
