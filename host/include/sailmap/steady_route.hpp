// What a route says where single images say little, as when a night is compared with a day, or winter with
// summer: the route of a camera that hardly ever leaves it, followed through images that show nothing or a
// wrong place.
#pragma once

#include <span>
#include <vector>

#include "sailmap/route_model.hpp"
#include "sailmap/score_evidence.hpp"

namespace sailmap {

// It is believed as far as it explains the images better than the usual route model does, which is soon at a
// loss where images say little, and as far as images were seen to err along it. Where images are mostly
// right, or follow no route, it says nothing.
class SteadyRoute {
 public:
  // `images`: see RouteModel.
  explicit SteadyRoute(int images);

  // The next image, with what RouteModel::advance wants; `usual`: how likely the usual model found it
  // (RouteModel::Estimate::expected). Returns odds to be added to those of each candidate.
  std::vector<float> advance(const ScoreEvidence::Row& row, std::span<const float> likelihoods, double shown,
                             double usual);

  // Nothing is known of where the camera is; what was learned stays.
  void lose();

  // How much it is believed, 0 .. 1.
  [[nodiscard]] double belief() const { return belief_; }

 private:
  void compare(double expected, double usual);
  void judge_image(const ScoreEvidence::Row& row, const std::vector<float>& followed, double trust);

  RouteModel route_;
  double forget_lead_, forget_errors_;  // parts, an image
  double lead_;                         // logarithm of the odds against the usual model
  double errors_ = 0, judged_ = 0;      // images, decayed
  double belief_ = 0;
};

}  // namespace sailmap
