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

// log(p_i / sum of all p but p_i) of the first `count` of p = exp(logs), up to a common factor.
std::vector<double> odds_against_the_rest(const std::vector<double>& logs, std::size_t count) {
  const auto first = std::ranges::max_element(logs);
  const auto top = static_cast<std::size_t>(first - logs.begin());
  // Without the largest, which would leave nothing of the others in the sum when it is taken off again.
  double second = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < logs.size(); ++i) {
    if (i != top) second = std::max(second, logs[i]);
  }
  double others = 0;
  for (std::size_t i = 0; i < logs.size(); ++i) others += i == top ? 0 : std::exp(logs[i] - second);
  std::vector<double> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (i == top) {
      out[i] = logs[i] - second - std::log(others);
    } else {
      const double rest = std::exp(second - logs[top]) * (others - std::exp(logs[i] - second));
      out[i] = logs[i] - logs[top] - std::log1p(std::max(0.0, rest));
    }
  }
  return out;
}

}  // namespace

Fabmap::Fabmap(const Vocabulary& vocabulary, const FabmapConfig& config)
    : config_(config), places_(vocabulary.tree, config), samples_(vocabulary.tree, config) {
  if (vocabulary.training.empty()) throw Error("fabmap: the vocabulary has no training image");
  for (const Words& words : vocabulary.training) samples_.add(words);
}

std::vector<double> Fabmap::log_odds(const Words& image, std::size_t count) const {
  std::vector<double> scores = places_.log_likelihoods(image);
  scores.resize(std::min(count, scores.size()));
  if (scores.empty()) return scores;
  const std::size_t places = scores.size();
  const double each = std::log((1 - config_.new_place_prior) / static_cast<double>(places));
  for (double& score : scores) score += each;
  scores.push_back(log_mean_exp(samples_.log_likelihoods(image)) + std::log(config_.new_place_prior));
  return odds_against_the_rest(scores, places);
}

}  // namespace sailmap::fabmap
