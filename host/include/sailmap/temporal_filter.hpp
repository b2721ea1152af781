// What the images just before say about where this one is: a filter over the scores of any method, causal,
// for either direction of travel and for changing speed (docs/recognition.md).
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "sailmap/ref/plane.hpp"
#include "sailmap/route_model.hpp"
#include "sailmap/score_evidence.hpp"
#include "sailmap/similarity.hpp"
#include "sailmap/steady_route.hpp"

namespace sailmap {

struct TemporalConfig {
  int images = 0;  // how long it remembers how the images were ordered, 0 .. 1000; 0 or 1: no filter
  // The score that means even odds in the method's scale, > 0. Infinity: the scores are within 0 and 1, and
  // 0.5 means even odds.
  double scale = 1;
  // To which power the forecast counts where the filter is trusted, 0 .. 1. Images that follow each other
  // resemble each other, so that they tell less than independent ones, of power 1, would.
  double power = 0.5;
  // From which odds on, > 0, the image tells one place from the next better than the route does, whose speed
  // is a guess: the route then favours neighbours alike. Infinity: never.
  double telling_odds = std::numeric_limits<double>::infinity();
};

// Fed the scores of one image after the other.
class TemporalFilter {
 public:
  // Throws Error when the configuration is out of range.
  explicit TemporalFilter(const TemporalConfig& config);

  // `scores`: of this image with candidates 0 .. n-1, NaN where not admissible (and so it stays); n may
  // differ from image to image, candidates keep their numbers and come in the order of travel. Returns n
  // filtered scores in the method's scale.
  std::vector<float> apply(std::span<const float> scores);

  // How sure it is that the images follow a route travelled before, 0 .. 1: the filter's weight.
  [[nodiscard]] double trust() const { return route_.trust(); }

 private:
  // What the images before say about the candidates of one image.
  struct Support {
    std::vector<float> factors;  // of the odds that stand out
    std::vector<float> missed;   // odds to be added, where the route led to what the image alone did not show
    bool led = false;            // that images err along the route is known: it may overrule them
  };

  [[nodiscard]] bool repeats(std::span<const float> scores) const;
  [[nodiscard]] Support support(const ScoreEvidence::Row& row);

  TemporalConfig config_;
  ScoreEvidence evidence_;
  RouteModel route_;
  SteadyRoute steady_;
  std::vector<float> last_scores_;
  Support last_support_;
};

// What fits a method. `context`: no scale, because its scores are calibrated, and a power of 0.3, because
// they hold part of what the route says already; it tells neighbours apart from odds of 0.5 on. All others:
// their default threshold and 0.5, and the route chooses among neighbours.
TemporalConfig temporal_config(Method method, int images);

// How many images the filter spans where it is on by default.
inline constexpr int default_temporal_images = 10;

// Row by row.
Plane<float> filter_scores(const Plane<float>& scores, const TemporalConfig& config);

}  // namespace sailmap
