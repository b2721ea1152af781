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

// From one image to the next a path moves on by 0 .. 4 candidates. How likely each is at about the speed of
// the candidates, at a slower one, and at a faster one.
using StepWeights = std::array<float, 5>;
constexpr std::array<StepWeights, 3> weights_of_speed = {
    {{0.8F, 1.0F, 0.85F, 0.7F, 0.6F}, {1.0F, 1.0F, 0.8F, 0.6F, 0.5F}, {0.5F, 0.7F, 1.0F, 1.0F, 0.9F}}};

// Trust begins in the middle, is lost with best candidates that no sequence foretold, and fades over 20
// images.
constexpr double prior_trust = 0.4;
constexpr double memory = 0.95;
constexpr double no_trust = 0.5;  // at this part of best candidates foretold, or below, the filter is off ...
constexpr double full_trust = 0.9;  // ... and from here on it has its full weight
constexpr double full_weight = 0.7;
constexpr std::ptrdiff_t foretold_within = 2;  // candidates

bool admissible(float score) { return !std::isnan(score); }

float at(const std::vector<float>& values, std::ptrdiff_t index) {
  return index >= 0 && index < static_cast<std::ptrdiff_t>(values.size())
             ? values[static_cast<std::size_t>(index)]
             : 0.0F;
}

// The best evidence that a path in `direction` (1 or -1) brings to each of `count` candidates.
std::vector<float> carried(const std::vector<float>& evidence, std::size_t count, const StepWeights& weights,
                           int direction) {
  std::vector<float> out(count, 0.0F);
  for (std::size_t c = 0; c < count; ++c) {
    for (std::size_t step = 0; step < weights.size(); ++step) {
      const auto from = static_cast<std::ptrdiff_t>(c) - direction * static_cast<std::ptrdiff_t>(step);
      out[c] = std::max(out[c], weights[step] * at(evidence, from));
    }
  }
  return out;
}

std::ptrdiff_t first_highest(const std::vector<float>& values) {
  return std::max_element(values.begin(), values.end()) - values.begin();
}

std::vector<float> stronger(const std::vector<float>& a, const std::vector<float>& b) {
  std::vector<float> out(a.size());
  std::transform(a.begin(), a.end(), b.begin(), out.begin(), [](float x, float y) { return std::max(x, y); });
  return out;
}

// How far the best score stands out from the middle one; below 0 where no score is above 0: such an image
// tells nothing about sequences.
double prominence(const std::vector<float>& single) {
  std::vector<float> positive;
  std::copy_if(single.begin(), single.end(), std::back_inserter(positive), [](float s) { return s > 0; });
  if (positive.empty()) return -1;
  const auto middle = positive.begin() + static_cast<std::ptrdiff_t>(positive.size() / 2);
  std::nth_element(positive.begin(), middle, positive.end());
  return static_cast<double>(*std::max_element(single.begin(), single.end()) - *middle);
}

}  // namespace

TemporalFilter::TemporalFilter(const TemporalConfig& config) : config_(config) {
  if (config.images < 0 || config.images > 1000) {
    throw Error("temporal filter: " + std::to_string(config.images) + " images; there may be 0 to 1000");
  }
  if (!(config.scale > 0)) throw Error("temporal filter: the scale must be above 0");
  if (config.images > 1) keep_ = 1.0F - 1.0F / static_cast<float>(config.images);
  for (Track& track : tracks_) {
    track.right = prior_trust;
    track.all = 1;
  }
}

const TemporalFilter::Track& TemporalFilter::most_trusted() const {
  return *std::max_element(tracks_.begin(), tracks_.end(),
                           [](const Track& a, const Track& b) { return a.trust() < b.trust(); });
}

double TemporalFilter::trust() const {
  return std::clamp((most_trusted().trust() - no_trust) / (full_trust - no_trust), 0.0, 1.0);
}

std::vector<float> TemporalFilter::advance(std::size_t speed, const std::vector<float>& single) {
  Track& track = tracks_[speed];
  const bool first = track.forward.empty();
  track.forward = carried(track.forward, single.size(), weights_of_speed[speed], 1);
  track.backward = carried(track.backward, single.size(), weights_of_speed[speed], -1);
  if (!first) {
    const bool right = std::abs(first_highest(single) -
                                first_highest(stronger(track.forward, track.backward))) <= foretold_within;
    const double weight = prominence(single);
    if (weight >= 0) {
      track.right = memory * track.right + (1 - memory) * prior_trust + (right ? weight : 0);
      track.all = memory * track.all + (1 - memory) + weight;
    }
  }
  // A mean over the path, the newest image weighing most: at most the best single score.
  for (std::size_t c = 0; c < single.size(); ++c) {
    track.forward[c] = (1 - keep_) * single[c] + keep_ * track.forward[c];
    track.backward[c] = (1 - keep_) * single[c] + keep_ * track.backward[c];
  }
  return stronger(track.forward, track.backward);
}

std::vector<float> TemporalFilter::apply(std::span<const float> scores) {
  std::vector<float> out(scores.begin(), scores.end());
  if (keep_ == 0 || std::none_of(out.begin(), out.end(), admissible)) {
    for (Track& track : tracks_) track.forward.clear();
    for (Track& track : tracks_) track.backward.clear();
    return out;
  }
  const bool compressed = std::isfinite(config_.scale);
  const auto scale = static_cast<float>(config_.scale);
  std::vector<float> single(out.size(), 0.0F);
  for (std::size_t c = 0; c < out.size(); ++c) {
    if (admissible(out[c])) single[c] = compressed ? out[c] / (out[c] + scale) : out[c];
  }
  std::array<std::vector<float>, speeds> evidence;
  for (std::size_t speed = 0; speed < speeds; ++speed) evidence[speed] = advance(speed, single);
  const auto best = static_cast<std::size_t>(&most_trusted() - tracks_.data());
  const auto weight = static_cast<float>(full_weight * trust());
  for (std::size_t c = 0; c < out.size(); ++c) {
    if (!admissible(out[c])) {
      for (Track& track : tracks_) track.forward[c] = track.backward[c] = 0;
      continue;
    }
    const float mixed = (1 - weight) * single[c] + weight * evidence[best][c];
    out[c] = !compressed ? mixed : mixed < 1 ? scale * mixed / (1 - mixed) : out[c];
  }
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
