#include "sailmap/bag_of_words.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "sailmap/evaluation.hpp"

namespace sailmap::bow {
namespace {

using fabmap::Histogram;

// The histogram's parts times the words' rarity, scaled to unit length; all 0 when no word has weight.
Histogram weighted(const Histogram& histogram, const std::vector<double>& rarity) {
  fabmap::check_words(histogram.words, rarity.size());
  Histogram out = histogram;
  double squares = 0;
  for (std::size_t i = 0; i < out.words.size(); ++i) {
    out.parts[i] *= rarity[static_cast<std::size_t>(out.words[i])];
    squares += out.parts[i] * out.parts[i];
  }
  for (double& part : out.parts) part /= squares > 0 ? std::sqrt(squares) : 1;
  return out;
}

std::vector<Histogram> weighted(const std::vector<Histogram>& images, const std::vector<double>& rarity) {
  std::vector<Histogram> out;
  for (const Histogram& image : images) out.push_back(weighted(image, rarity));
  return out;
}

// Both have their words in rising order.
double dot(const Histogram& a, const Histogram& b) {
  double sum = 0;
  for (std::size_t i = 0, k = 0; i < a.words.size() && k < b.words.size();) {
    if (a.words[i] == b.words[k]) sum += a.parts[i] * b.parts[k];
    const bool advance = a.words[i] <= b.words[k];
    k += b.words[k] <= a.words[i] ? 1 : 0;
    i += advance ? 1 : 0;
  }
  return std::min(sum, 1.0);
}

// Row q holds the similarity of query q with candidates [0, admissible(q)).
template <class Admissible>
Plane<float> score(const std::vector<Histogram>& queries, const std::vector<Histogram>& candidates,
                   Admissible admissible) {
  Plane<float> scores(static_cast<int>(candidates.size()), static_cast<int>(queries.size()), not_admissible);
  tbb::parallel_for(std::size_t{0}, queries.size(), [&](std::size_t q) {
    for (std::size_t c = 0; c < admissible(q); ++c) {
      scores(static_cast<int>(c), static_cast<int>(q)) = static_cast<float>(dot(queries[q], candidates[c]));
    }
  });
  return scores;
}

}  // namespace

std::vector<double> rarity(const fabmap::Vocabulary& vocabulary) {
  std::vector<double> seen(vocabulary.tree.size(), 0);
  for (const fabmap::Words& words : vocabulary.training) {
    for (const int word : words) ++seen[static_cast<std::size_t>(word)];
  }
  const auto images = static_cast<double>(vocabulary.training.size());
  for (double& count : seen) count = std::log((images + 1) / (count + 1));
  return seen;
}

double similarity(const Histogram& a, const Histogram& b, const std::vector<double>& rarity) {
  return dot(weighted(a, rarity), weighted(b, rarity));
}

Plane<float> score_sequence(const std::vector<Histogram>& images, int exclude_recent,
                            const fabmap::Vocabulary& vocabulary) {
  if (exclude_recent < 0) throw Error("exclude_recent must not be negative");
  const auto recent = static_cast<std::size_t>(exclude_recent);
  const std::vector<Histogram> all = weighted(images, rarity(vocabulary));
  return score(all, all, [recent](std::size_t q) { return q - std::min(q, recent); });
}

Plane<float> score_traverses(const std::vector<Histogram>& queries, const std::vector<Histogram>& references,
                             const fabmap::Vocabulary& vocabulary) {
  const std::vector<double> weights = rarity(vocabulary);
  return score(weighted(queries, weights), weighted(references, weights),
               [&references](std::size_t) { return references.size(); });
}

}  // namespace sailmap::bow
