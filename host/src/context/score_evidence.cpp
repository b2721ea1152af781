#include "sailmap/score_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

namespace sailmap {
namespace {

// The odds that a true place may score by bad luck: an image that shows it says next to nothing.
constexpr float bad_luck = 0.01F;

// A candidate counts as usual, mean 1, until it was seen in clearly more images than these.
constexpr float images_of_usual = 5;

// Scores nearer to 1 would have odds that single precision cannot tell from each other.
constexpr float below_one = 1 - 1e-6F;

float odds_of(float score, double scale) {
  const float positive = std::max(0.0F, score);
  if (std::isfinite(scale)) return positive / static_cast<float>(scale);
  const float part = std::min(positive, below_one);
  return part / (1 - part);
}

// What so many candidates reach, or half of them where there are few, does not stand out: the true place and
// its neighbours are fewer.
constexpr std::size_t common = 10;

float common_level(std::vector<float> values) {
  const auto level = values.begin() + static_cast<std::ptrdiff_t>(std::min(common, values.size() / 2));
  std::nth_element(values.begin(), level, values.end(), std::greater<>());
  return *level;
}

void divide(std::vector<float>& values, double by) {
  for (float& value : values) value = static_cast<float>(value / by);
}

double sum_of(const std::vector<float>& values) {
  double sum = 0;
  for (const float value : values) sum += value;
  return sum;
}

}  // namespace

float ScoreEvidence::score(float odds) const {
  return std::isfinite(scale_) ? static_cast<float>(scale_) * odds : odds / (1 + odds);
}

ScoreEvidence::Row ScoreEvidence::read(std::span<const float> scores) const {
  Row row{std::vector<float>(scores.size(), 0.0F), std::vector<float>(scores.size(), 0.0F),
          std::vector<bool>(scores.size(), false), 0};
  std::vector<float> odds;
  for (std::size_t c = 0; c < scores.size(); ++c) {
    if (std::isnan(scores[c])) continue;
    row.admissible[c] = true;
    row.odds[c] = odds_of(scores[c], scale_);
    odds.push_back(row.odds[c]);
  }
  row.count = static_cast<int>(odds.size());
  if (odds.empty()) return row;
  const float level = common_level(std::move(odds));
  for (std::size_t c = 0; c < scores.size(); ++c) row.standing[c] = std::max(0.0F, row.odds[c] - level);
  return row;
}

std::vector<float> ScoreEvidence::likelihoods(const Row& row) {
  std::vector<float> out(row.odds.size(), 0.0F);
  for (std::size_t c = 0; c < out.size(); ++c) {
    if (row.admissible[c]) out[c] = row.standing[c] + bad_luck;
  }
  divide(out, sum_of(out) / row.count);
  sums_.resize(std::max(sums_.size(), out.size()), 0.0F);
  counts_.resize(std::max(counts_.size(), out.size()), 0.0F);
  // Some candidates score with every image, as places without features do: what counts is by how much more.
  for (std::size_t c = 0; c < out.size(); ++c) {
    if (!row.admissible[c]) continue;
    const float likelihood = out[c];
    out[c] *= (counts_[c] + images_of_usual) / (sums_[c] + images_of_usual);
    sums_[c] += likelihood;
    counts_[c] += 1;
  }
  divide(out, sum_of(out) / row.count);
  return out;
}

}  // namespace sailmap
