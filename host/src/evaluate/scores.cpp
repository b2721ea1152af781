// Similarity of every query with every admissible candidate.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <span>
#include <vector>

#include "sailmap/context.hpp"
#include "sailmap/error.hpp"
#include "sailmap/evaluation.hpp"

namespace sailmap {
namespace {

// Row q holds the scores of query q against candidates [0, admissible(q)).
template <class Admissible>
Plane<float> score(const std::vector<Signature>& queries, const std::vector<Signature>& candidates,
                   const MatchConfig& config, Admissible admissible) {
  Plane<float> scores(static_cast<int>(candidates.size()), static_cast<int>(queries.size()), not_admissible);
  std::vector<const PlaceDescriptor*> places;
  places.reserve(candidates.size());
  for (const Signature& candidate : candidates) places.push_back(&candidate.place.get());
  tbb::parallel_for(std::size_t{0}, queries.size(), [&](std::size_t q) {
    if (config.method == Method::context) {
      const auto row = score_contexts(queries[q].place, std::span(places).first(admissible(q)));
      for (std::size_t c = 0; c < row.size(); ++c) scores(static_cast<int>(c), static_cast<int>(q)) = row[c];
      return;
    }
    for (std::size_t c = 0; c < admissible(q); ++c) {
      scores(static_cast<int>(c), static_cast<int>(q)) =
          static_cast<float>(match(queries[q], candidates[c], config).similarity);
    }
  });
  return scores;
}

}  // namespace

Plane<float> score_sequence(const std::vector<Signature>& images, int exclude_recent,
                            const MatchConfig& config) {
  if (exclude_recent < 0) throw Error("exclude_recent must not be negative");
  const auto recent = static_cast<std::size_t>(exclude_recent);
  return score(images, images, config, [recent](std::size_t q) { return q - std::min(q, recent); });
}

Plane<float> score_traverses(const std::vector<Signature>& queries, const std::vector<Signature>& references,
                             const MatchConfig& config) {
  return score(queries, references, config, [&references](std::size_t) { return references.size(); });
}

}  // namespace sailmap
