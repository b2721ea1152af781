// Spec section 10, eq. 7: how alike two images are.
#include "sailmap/similarity.hpp"

#include <algorithm>
#include <string>

#include "match/check.hpp"
#include "sailmap/context.hpp"
#include "sailmap/error.hpp"

namespace sailmap {

void check_same_size(const Signature& query, const Signature& candidate) {
  if (query.width != candidate.width || query.height != candidate.height) {
    const auto size = [](const Signature& s) {
      return std::to_string(s.width) + "x" + std::to_string(s.height);
    };
    throw Error("images of different size cannot be compared: " + size(query) + " and " + size(candidate));
  }
}

void check_match_config(const MatchConfig& config) {
  if (!(config.search_radius > 0)) throw Error("match configuration: search_radius must be above 0");
  if (!(config.displacement_tolerance >= 0)) {
    throw Error("match configuration: displacement_tolerance must not be negative");
  }
  if (!(config.similarity_cap > 0)) throw Error("match configuration: similarity_cap must be above 0");
}

MatchResult match(const Signature& query, const Signature& candidate, const MatchConfig& config) {
  if (config.method == Method::context) return match_places(query.place, candidate.place);
  check_same_size(query, candidate);
  check_match_config(config);
  MatchResult out;
  out.matches = consistent_matches(query, candidate, nearest_matches(query, candidate, config), config);
  if (out.matches.empty()) return out;
  double sum = 0;
  for (const RegionMatch& match : out.matches) sum += match.distance;
  const auto matched = static_cast<double>(out.matches.size());
  double weight = 1;
  if (config.method == Method::paper_weighted) {
    weight = matched / static_cast<double>(std::max(query.regions.size(), candidate.regions.size()));
  }
  // Identical images: no distance at all, similarity would be infinite. The weight stays, so that among
  // identical regions more of them still count for more.
  out.similarity = weight * std::min(sum > 0 ? matched / sum : config.similarity_cap, config.similarity_cap);
  return out;
}

}  // namespace sailmap
