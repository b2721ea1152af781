// FAB-MAP's log-odds of every query with every admissible place.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "sailmap/evaluation.hpp"
#include "sailmap/temporal_filter.hpp"

namespace sailmap::fabmap {
namespace {

// Row q holds the log-odds of query q against places [0, admissible(q)).
template <class Admissible>
Plane<float> score(const std::vector<Words>& queries, const std::vector<Words>& places,
                   const Vocabulary& vocabulary, const FabmapConfig& config, Admissible admissible) {
  Fabmap fabmap(vocabulary, config);
  for (const Words& place : places) fabmap.add(place);
  Plane<float> scores(static_cast<int>(places.size()), static_cast<int>(queries.size()), not_admissible);
  tbb::parallel_for(std::size_t{0}, queries.size(), [&](std::size_t q) {
    const std::vector<double> row = fabmap.log_odds(queries[q], admissible(q));
    for (std::size_t c = 0; c < row.size(); ++c) {
      scores(static_cast<int>(c), static_cast<int>(q)) = static_cast<float>(row[c]);
    }
  });
  return scores;
}

// The words of an image depend on each other more than a tree tells, so that nearly all probabilities are 0
// or 1 and a mean of them would count votes. For the filter the log-odds are divided by this.
constexpr float temperature = 10;
constexpr float most = 80;  // what exp takes and gives as a float, either way

}  // namespace

Plane<float> score_sequence(const std::vector<Words>& images, int exclude_recent,
                            const Vocabulary& vocabulary, const FabmapConfig& config) {
  if (exclude_recent < 0) throw Error("exclude_recent must not be negative");
  const auto recent = static_cast<std::size_t>(exclude_recent);
  return score(images, images, vocabulary, config,
               [recent](std::size_t q) { return q - std::min(q, recent); });
}

Plane<float> score_traverses(const std::vector<Words>& queries, const std::vector<Words>& references,
                             const Vocabulary& vocabulary, const FabmapConfig& config) {
  return score(queries, references, vocabulary, config,
               [&references](std::size_t) { return references.size(); });
}

Plane<float> filter_log_odds(const Plane<float>& log_odds, int images) {
  if (images < 2) return log_odds;
  // The filter compresses s to s / (s + 1): of odds that is the probability.
  Plane<float> odds = log_odds;
  for (float& value : odds.samples()) {
    if (!std::isnan(value)) value = std::exp(std::clamp(value / temperature, -most, most));
  }
  Plane<float> filtered = filter_scores(odds, {.images = images, .scale = 1});
  for (float& value : filtered.samples()) {
    if (!std::isnan(value)) value = temperature * std::max(std::log(value), -most);
  }
  return filtered;
}

}  // namespace sailmap::fabmap
