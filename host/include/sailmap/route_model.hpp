// Where a camera is along a route that was travelled before: a hidden Markov model over candidates and
// directions of travel. It learns how many candidates an image moves on, how often the route breaks off, and
// whether the images follow any route at all.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace sailmap {

class RouteModel {
 public:
  // `images`: how long what was learned lasts (about twice as many for steps, five times for breaks); above
  // 0. `first_breaks`: part of the images at which a path is thought to break off, until some ten images
  // showed how it is; 0 .. 1.
  explicit RouteModel(int images, double first_breaks = 0.3);

  // What is known of an image.
  struct Estimate {
    // From the images before: how much likelier each candidate is than anywhere. All 1 for the first image.
    std::vector<float> prior;
    // With the image itself: that the route went on as foretold and led to about here.
    std::vector<float> followed;
    double expected = 1;  // likelihood of the image under the forecast, relative to no forecast
    double on_map = 1;    // how much of the forecast is on the map, where paths do not break off, 0 .. 1
    double attested = 0;  // how much of it comes from paths along which an image showed its place, 0 .. 1
  };

  // The next image: likelihoods of mean 1 over the `admissible` candidates, which come in the order of
  // travel; 0 for the others. `shown`: how sure it is by this image alone that it shows any of them, 0 .. 1.
  Estimate advance(std::span<const float> likelihoods, int admissible, double shown);

  // Nothing is known of where the camera is; what was learned stays.
  void lose();

  // 0 .. 1: that the images follow a route, above even odds.
  [[nodiscard]] double trust() const;
  // Part of the images that broke off the route, if it hardly ever does until shown otherwise.
  [[nodiscard]] double observed_breaks() const;

 private:
  static constexpr std::size_t steps = 7;
  using Steps = std::array<double, steps>;
  // The forecast by way of each number of candidates, before the break rate comes in.
  struct Forecast {
    std::vector<float> forward, backward;  // all paths
    std::vector<float> confirmed;          // of both directions, those that are more than one image old
  };

  [[nodiscard]] Steps step_probabilities() const;
  [[nodiscard]] double break_rate() const;
  [[nodiscard]] Forecast forecast(const Steps& probabilities, std::span<const float> likelihoods) const;
  [[nodiscard]] Steps explained_by(const Steps& probabilities, std::span<const float> likelihoods) const;
  void learn(const Steps& explained, double went_on);
  void judge_order(double expected);
  [[nodiscard]] double attested(const Forecast& ahead, std::span<const float> likelihoods) const;

  double first_breaks_;
  double keep_steps_, keep_breaks_, change_of_order_;
  // Posterior of the last image: paths in either direction, and those that begin there.
  std::vector<float> forward_, backward_, fresh_;
  // Part of the paths, and of those that begin, along which an image showed its place.
  double attested_paths_ = 0, attested_fresh_ = 0;
  Steps step_counts_{};
  double breaks_ = 0, counted_ = 0;  // decayed
  double order_;                     // probability that the images follow a route
};

}  // namespace sailmap
