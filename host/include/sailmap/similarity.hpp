// Similarity of two images, eq. 7 with both geometric constraints (spec 10).
#pragma once

#include <string_view>
#include <vector>

#include "sailmap/signature.hpp"

namespace sailmap {

enum class Method { paper, paper_weighted, context };

std::string_view name(Method method);
// Throws Error for an unknown name.
Method method_from_name(std::string_view name);
std::vector<std::string_view> method_names();

struct MatchConfig {
  Method method = Method::paper_weighted;
  double search_radius = 0.15;           // constraint 1, Delta as a part of the image diagonal; > 0
  double displacement_tolerance = 0.08;  // constraint 2, as a part of the image diagonal; >= 0
  double similarity_cap = 1e6;           // what infinite similarity (identical images) counts as; > 0
};

// Region `query` of the first image matched with region `candidate` of the second.
struct RegionMatch {
  int query = 0;
  int candidate = 0;
  double distance = 0;  // Euclidean, between descriptors
  bool operator==(const RegionMatch&) const = default;
};

struct MatchResult {
  double similarity = 0;             // 0 when nothing matches
  std::vector<RegionMatch> matches;  // MR, by query region
};

// Constraint 1 and nearest descriptor: for each query region the admissible candidate of least distance, if
// any.
std::vector<RegionMatch> nearest_matches(const Signature& query, const Signature& candidate,
                                         const MatchConfig& config);

// Constraint 2: the largest subset of one displacement: those whose displacement (candidate - query) agrees,
// within the tolerance, with that of one of them, the one that most agree with (the first in order on ties).
std::vector<RegionMatch> consistent_matches(const Signature& query, const Signature& candidate,
                                            const std::vector<RegionMatch>& matches,
                                            const MatchConfig& config);

// Eq. 7. The images must have the same size, otherwise throws Error. Method `context`: match_places, of any
// size.
MatchResult match(const Signature& query, const Signature& candidate, const MatchConfig& config);

}  // namespace sailmap
