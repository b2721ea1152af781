// What the images just before say about where this one is: a filter over the scores of any method, causal,
// for either direction of travel and for changing speed (docs/recognition.md).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "sailmap/ref/plane.hpp"
#include "sailmap/similarity.hpp"

namespace sailmap {

struct TemporalConfig {
  int images =
      0;  // how long evidence lasts, 0 .. 1000: after so many images 1/e of it is left; 0 or 1: no filter
  // What counts as similar in the method's scale, > 0: scores are compressed by s / (s + scale) inside the
  // filter, so that one outlier does not outweigh a sequence. Infinity: the scores are within 0 and 1
  // already.
  double scale = 1;
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

  // How far sequences, at the speed that suits best, have foretold the best candidates so far, 0 .. 1: the
  // weight of the filter's own evidence.
  [[nodiscard]] double trust() const;

 private:
  // What the filter knows under one assumption about the speed of travel.
  struct Track {
    std::vector<float> forward;  // evidence along the best path that ends at each candidate
    std::vector<float> backward;
    double right = 0;  // decayed evidence for best candidates that were foretold ...
    double all = 0;    // ... and for all best candidates
    [[nodiscard]] double trust() const { return right / all; }
  };
  static constexpr std::size_t speeds = 3;

  [[nodiscard]] const Track& most_trusted() const;
  // Carries a track on to an image of these scores; returns the evidence for each candidate.
  std::vector<float> advance(std::size_t speed, const std::vector<float>& single);

  TemporalConfig config_;
  float keep_ = 0;  // part of the evidence kept from image to image
  std::array<Track, speeds> tracks_;
};

// What fits a method: the scale is its default threshold, or none for `context`, whose scores are calibrated.
TemporalConfig temporal_config(Method method, int images);

// How many images the filter spans where it is on by default.
inline constexpr int default_temporal_images = 10;

// Row by row.
Plane<float> filter_scores(const Plane<float>& scores, const TemporalConfig& config);

}  // namespace sailmap
