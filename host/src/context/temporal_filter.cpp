#include "sailmap/temporal_filter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <string>

#include "sailmap/detection.hpp"
#include "sailmap/error.hpp"

namespace sailmap {
namespace {

// From one image to the next a path moves on by 0 .. 4 candidates; one is the most likely.
constexpr std::array<float, 5> step_weights = {0.85F, 1.0F, 0.9F, 0.8F, 0.7F};

// Trust begins in the middle, is lost with best candidates that no sequence foretold, and fades over 20
// images.
constexpr double prior_trust = 0.4;
constexpr double memory = 0.95;
constexpr double no_trust = 0.5;  // at this part of best candidates foretold, or below, the filter is off ...
constexpr double full_trust = 0.85;  // ... and from here on it has its full weight
constexpr double full_weight = 0.7;
constexpr std::ptrdiff_t foretold_within = 3;  // candidates

bool admissible(float score) { return !std::isnan(score); }

float at(const std::vector<float>& values, std::ptrdiff_t index) {
  return index >= 0 && index < static_cast<std::ptrdiff_t>(values.size())
             ? values[static_cast<std::size_t>(index)]
             : 0.0F;
}

// The best evidence that a path in `direction` (1 or -1) brings to each of `count` candidates.
std::vector<float> carried(const std::vector<float>& evidence, std::size_t count, int direction) {
  std::vector<float> out(count, 0.0F);
  for (std::size_t c = 0; c < count; ++c) {
    for (std::size_t step = 0; step < step_weights.size(); ++step) {
      const auto from = static_cast<std::ptrdiff_t>(c) - direction * static_cast<std::ptrdiff_t>(step);
      out[c] = std::max(out[c], step_weights[step] * at(evidence, from));
    }
  }
  return out;
}

std::ptrdiff_t first_highest(const std::vector<float>& values) {
  return std::max_element(values.begin(), values.end()) - values.begin();
}

}  // namespace

TemporalFilter::TemporalFilter(const TemporalConfig& config) : config_(config) {
  if (config.images < 0 || config.images > 1000) {
    throw Error("temporal filter: " + std::to_string(config.images) + " images; there may be 0 to 1000");
  }
  if (!(config.scale > 0)) throw Error("temporal filter: the scale must be above 0");
  if (config.images > 1) keep_ = 1.0F - 1.0F / static_cast<float>(config.images);
  right_ = prior_trust;
  all_ = 1;
}

double TemporalFilter::trust() const {
  return std::clamp((right_ / all_ - no_trust) / (full_trust - no_trust), 0.0, 1.0);
}

void TemporalFilter::update_trust(const std::vector<float>& single, const std::vector<float>& foretold) {
  const std::ptrdiff_t best = first_highest(single);
  std::vector<float> positive;
  std::copy_if(single.begin(), single.end(), std::back_inserter(positive), [](float s) { return s > 0; });
  if (positive.empty()) return;
  const auto middle = positive.begin() + static_cast<std::ptrdiff_t>(positive.size() / 2);
  std::nth_element(positive.begin(), middle, positive.end());
  // An image that stands out nowhere tells nothing about sequences.
  const double weight = single[static_cast<std::size_t>(best)] - *middle;
  const bool right = std::abs(best - first_highest(foretold)) <= foretold_within;
  right_ = memory * right_ + (1 - memory) * prior_trust + (right ? weight : 0);
  all_ = memory * all_ + (1 - memory) + weight;
}

std::vector<float> TemporalFilter::apply(std::span<const float> scores) {
  std::vector<float> out(scores.begin(), scores.end());
  if (keep_ == 0 || std::none_of(out.begin(), out.end(), admissible)) {
    forward_.clear();
    backward_.clear();
    return out;
  }
  const bool compressed = std::isfinite(config_.scale);
  const auto scale = static_cast<float>(config_.scale);
  std::vector<float> single(out.size(), 0.0F);
  for (std::size_t c = 0; c < out.size(); ++c) {
    if (admissible(out[c])) single[c] = compressed ? out[c] / (out[c] + scale) : out[c];
  }
  const bool first = forward_.empty();
  std::vector<float> forward = carried(forward_, out.size(), 1);
  std::vector<float> backward = carried(backward_, out.size(), -1);
  std::vector<float> foretold(out.size());
  for (std::size_t c = 0; c < out.size(); ++c) foretold[c] = std::max(forward[c], backward[c]);
  if (!first) update_trust(single, foretold);
  const auto weight = static_cast<float>(full_weight * trust());
  for (std::size_t c = 0; c < out.size(); ++c) {
    const bool counts = admissible(out[c]);
    // Evidence is a mean over the path, the newest image weighing most: at most the best single score.
    forward[c] = counts ? (1 - keep_) * single[c] + keep_ * forward[c] : 0;
    backward[c] = counts ? (1 - keep_) * single[c] + keep_ * backward[c] : 0;
    if (!counts) continue;
    const float mixed = (1 - weight) * single[c] + weight * std::max(forward[c], backward[c]);
    out[c] = !compressed ? mixed : mixed < 1 ? scale * mixed / (1 - mixed) : out[c];
  }
  forward_ = std::move(forward);
  backward_ = std::move(backward);
  return out;
}

TemporalConfig temporal_config(Method method, int images) {
  return {images,
          method == Method::context ? std::numeric_limits<double>::infinity() : default_threshold(method)};
}

Plane<float> filter_scores(const Plane<float>& scores, const TemporalConfig& config) {
  TemporalFilter filter(config);
  Plane<float> out = scores;
  const auto width = static_cast<std::size_t>(scores.width());
  for (std::size_t q = 0; q < static_cast<std::size_t>(scores.height()); ++q) {
    const std::vector<float> row = filter.apply(scores.samples().subspan(q * width, width));
    std::copy(row.begin(), row.end(), out.samples().begin() + static_cast<std::ptrdiff_t>(q * width));
  }
  return out;
}

}  // namespace sailmap
