#include "sailmap/temporal_filter.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "sailmap/detection.hpp"
#include "sailmap/error.hpp"

namespace sailmap {
namespace {

// What the forecast does not have loses half of its odds at most: a break is never so unlikely that an image
// which shows another place clearly should fall behind images that show none.
constexpr float least_factor = 0.5F;

// What the route adds where it is as likely as all else together, in odds: a place that no image would have
// shown alone is then believed as one that scores 0.6. Chosen on the corridor, whose blank walls need
// it: less loses them again.
constexpr double odds_of_missed = 1.5;
// Only where paths hardly ever break: in full up to one image in 25, not at all from one in 17.
constexpr double few_breaks = 0.04, many_breaks = 0.06;

// And only places where at least so much of the path is: when a route has ended and images show nothing, what
// is left of it spreads over the map.
constexpr float least_followed = 0.2F;

// The choice is the image's own where it is rather sure than not: a route that ends or breaks off looks like
// its continuation for an image or two. Where it does not tell places apart, only if it shows the other one
// clearly less.
constexpr float sure_odds = 1, clearly = 1.2F;
// Nor can a route lead to a place that the image all but excludes, being so much less likely than its best.
constexpr float excluding = 1000;
// But where images are known to err along the route, believed this much, what one of them excludes says
// little.
constexpr double enough_belief = 0.5;

TemporalConfig checked(const TemporalConfig& config) {
  if (config.images < 0 || config.images > 1000) {
    throw Error("temporal filter: " + std::to_string(config.images) + " images; there may be 0 to 1000");
  }
  if (!(config.scale > 0)) throw Error("temporal filter: the scale must be above 0");
  if (!(config.power >= 0 && config.power <= 1)) {
    throw Error("temporal filter: the power must be within 0 and 1");
  }
  if (!(config.telling_odds > 0)) throw Error("temporal filter: the telling odds must be above 0");
  return config;
}

float best_odds(const ScoreEvidence::Row& row) { return *std::max_element(row.odds.begin(), row.odds.end()); }

// Puts places behind the one that the image shows best: where it is sure, what it shows less, and else what
// it all but excludes, unless images are `led`.
void keep_choice(const ScoreEvidence::Row& row, double telling_odds, bool led, std::vector<float>& scores) {
  const auto best =
      static_cast<std::size_t>(std::max_element(row.odds.begin(), row.odds.end()) - row.odds.begin());
  const float odds = row.odds[best];
  if (odds <= 0 || (led && odds < sure_odds)) return;
  const float margin = odds < sure_odds ? excluding : (odds < telling_odds ? clearly : 1);
  const float behind = std::nextafter(scores[best], std::numeric_limits<float>::lowest());
  for (std::size_t c = 0; c < scores.size(); ++c) {
    if (c != best && row.admissible[c] && row.odds[c] * margin <= odds)
      scores[c] = std::min(scores[c], behind);
  }
}

// Each factor as large as those of the candidates before and behind it, where these stand out too.
void share_with_neighbours(const std::vector<float>& standing, std::vector<float>& factors) {
  float before = 0;
  for (std::size_t c = 0; c < standing.size(); ++c) {
    const float own = factors[c];
    if (standing[c] > 0) {
      const bool behind = c + 1 < standing.size() && standing[c + 1] > 0;
      factors[c] = std::max({before, own, behind ? factors[c + 1] : 0.0F});
    }
    before = standing[c] > 0 ? own : 0.0F;
  }
}

// At most even; 0 where there is too little of the path.
float odds_of_following(float followed) {
  if (followed < least_followed) return 0;
  return followed < 0.5F ? followed / (1 - followed) : 1.0F;
}

bool same(float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }

}  // namespace

TemporalFilter::TemporalFilter(const TemporalConfig& config)
    : config_(checked(config)),
      evidence_(config.scale),
      route_(std::max(1, config.images)),
      steady_(std::max(1, config.images)) {}

// A camera that stands still, or images that were doubled, bring nothing new.
bool TemporalFilter::repeats(std::span<const float> scores) const {
  const std::size_t count = std::min(scores.size(), last_scores_.size());
  return count > 0 && std::equal(scores.begin(), scores.begin() + static_cast<std::ptrdiff_t>(count),
                                 last_scores_.begin(), same);
}

TemporalFilter::Support TemporalFilter::support(const ScoreEvidence::Row& row) {
  const double trust = route_.trust();
  const double breaks = route_.observed_breaks();
  const float best = best_odds(row);
  const double shown = std::min(best, 1.0F);
  const std::vector<float> likelihoods = evidence_.likelihoods(row);
  RouteModel::Estimate estimate = route_.advance(likelihoods, row.count, shown * shown);
  const std::vector<float> steady = steady_.advance(row, likelihoods, shown * shown, estimate.expected);
  Support out{std::move(estimate.prior), std::move(estimate.followed), steady_.belief() >= enough_belief};
  // A path that may have left the map says less of where it is in it.
  const double still_on = estimate.on_map * estimate.on_map;
  const auto power = static_cast<float>(config_.power * trust * still_on);
  const double unbroken = std::clamp((many_breaks - breaks) / (many_breaks - few_breaks), 0.0, 1.0);
  // Where the image contradicts the forecast, the path has probably just broken.
  const double held = std::min(1.0, estimate.expected * estimate.expected);
  // Nor is a place put forward behind the map's end, or when no image showed where the path is: images of
  // what the map does not have follow some path through it, too.
  const double leading = still_on * estimate.attested * estimate.attested;
  const auto believed = static_cast<float>(odds_of_missed * trust * unbroken * held * leading);
  for (std::size_t c = 0; c < row.odds.size(); ++c) {
    out.factors[c] = row.standing[c] > 0 ? std::max(least_factor, std::pow(out.factors[c], power)) : 1.0F;
    out.missed[c] = std::max(believed * odds_of_following(out.missed[c]), steady[c]);
  }
  if (best >= config_.telling_odds) {
    share_with_neighbours(row.standing, out.factors);
  }
  return out;
}

std::vector<float> TemporalFilter::apply(std::span<const float> scores) {
  std::vector<float> out(scores.begin(), scores.end());
  if (config_.images < 2) return out;
  const ScoreEvidence::Row row = evidence_.read(scores);
  if (row.count == 0) {
    route_.lose();
    steady_.lose();
    last_scores_.clear();
    return out;
  }
  if (!repeats(scores)) last_support_ = support(row);
  last_scores_.assign(scores.begin(), scores.end());
  last_support_.factors.resize(out.size(), 1.0F);
  last_support_.missed.resize(out.size(), 0.0F);
  for (std::size_t c = 0; c < out.size(); ++c) {
    const float change = row.standing[c] * (last_support_.factors[c] - 1) + last_support_.missed[c];
    // What does not change keeps its full precision.
    if (!std::isnan(out[c]) && change != 0) out[c] = evidence_.score(row.odds[c] + change);
  }
  keep_choice(row, config_.telling_odds, last_support_.led, out);
  return out;
}

TemporalConfig temporal_config(Method method, int images) {
  if (method == Method::context) return {images, std::numeric_limits<double>::infinity(), 0.3, 0.5};
  return {images, default_threshold(method)};
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
