// p(L_i | Z), with what a new place would show estimated from the training images.
#include "sailmap/fabmap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "check.hpp"

namespace sailmap::fabmap {
namespace {

// log of the mean of exp(values).
double log_mean_exp(const std::vector<double>& values) {
  const double largest = *std::ranges::max_element(values);
  double sum = 0;
  for (const double value : values) sum += std::exp(value - largest);
  return largest + std::log(sum / static_cast<double>(values.size()));
}

}  // namespace

Fabmap::Fabmap(const Vocabulary& vocabulary, const FabmapConfig& config)
    : config_(config), places_(vocabulary.tree, config), samples_(vocabulary.tree, config) {
  if (vocabulary.training.empty()) throw Error("fabmap: the vocabulary has no training image");
  for (const Words& words : vocabulary.training) samples_.add(words);
}

Fabmap::Posterior Fabmap::posterior(const Words& image, std::size_t count) const {
  Posterior out;
  if (count == 0) return out;
  const std::vector<double> known = places_.log_likelihoods(image);
  const auto last = known.begin() + static_cast<std::ptrdiff_t>(std::min(count, known.size()));
  std::vector<double> scores(known.begin(), last);
  scores.push_back(log_mean_exp(samples_.log_likelihoods(image)));
  const double places = static_cast<double>(scores.size() - 1);
  for (double& score : scores) score += std::log((1 - config_.new_place_prior) / places);
  scores.back() += std::log(config_.new_place_prior * places / (1 - config_.new_place_prior));
  const double largest = *std::ranges::max_element(scores);
  double sum = 0;
  for (double& score : scores) sum += score = std::exp(score - largest);
  const double even = (1 - config_.smoothing) / static_cast<double>(scores.size());
  for (double& score : scores) score = config_.smoothing * score / sum + even;
  out.new_place = scores.back();
  scores.pop_back();
  out.places = std::move(scores);
  return out;
}

}  // namespace sailmap::fabmap
