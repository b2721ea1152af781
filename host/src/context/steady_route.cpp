#include "sailmap/steady_route.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sailmap {
namespace {

// A path is thought to break off at every tenth image until it is learned how it is: seldom enough to follow
// it for some images that show nothing, where one in three would lose it.
constexpr double seldom_breaks = 0.1;

// At first the usual model is thought twenty times likelier: images in pieces of a route look like a steady
// one for a while. And however long this one was better, a few breaks turn the odds again.
constexpr double first_lead = -3, largest_lead = 5;

// Part of the images along the route that are thought to err, worth so many images of judging. From so many
// on the route is believed, and wholly from so many.
constexpr double usual_errors = 0.1, worth_of_usual_errors = 5;
constexpr double some_errors = 0.3, many_errors = 0.45;

// An image's best within two candidates of the route's is no error: truth is about that wide.
constexpr std::ptrdiff_t near = 2;

// Surer than this no forecast makes of a place.
constexpr float surest = 0.95F;

std::ptrdiff_t best_of(const std::vector<float>& values) {
  return std::max_element(values.begin(), values.end()) - values.begin();
}

}  // namespace

SteadyRoute::SteadyRoute(int images)
    : route_(images, seldom_breaks),
      forget_lead_(1 / (5.0 * images)),
      forget_errors_(1 / (2.0 * images)),
      lead_(first_lead) {}

void SteadyRoute::lose() { route_.lose(); }

void SteadyRoute::compare(double expected, double usual) {
  lead_ += (first_lead - lead_) * forget_lead_ + std::log(expected / usual);
  lead_ = std::min(lead_, largest_lead);
}

// Counts as much as it is known where the route is.
void SteadyRoute::judge_image(const ScoreEvidence::Row& row, const std::vector<float>& followed,
                              double trust) {
  const std::ptrdiff_t led_to = best_of(followed);
  const bool errs = std::abs(best_of(row.odds) - led_to) > near;
  const double known = std::min(1.0F, followed[static_cast<std::size_t>(led_to)]);
  const double weight = trust * known * known;
  errors_ += weight * ((errs ? 1 : 0) - forget_errors_ * errors_);
  judged_ += weight * (1 - forget_errors_ * judged_);
}

std::vector<float> SteadyRoute::advance(const ScoreEvidence::Row& row, std::span<const float> likelihoods,
                                        double shown, double usual) {
  const double trust = route_.trust();
  RouteModel::Estimate estimate = route_.advance(likelihoods, row.count, shown);
  compare(estimate.expected, usual);
  judge_image(row, estimate.followed, trust);
  const double errors = (errors_ + worth_of_usual_errors * usual_errors) / (judged_ + worth_of_usual_errors);
  const double wanted = std::clamp((errors - some_errors) / (many_errors - some_errors), 0.0, 1.0);
  const double better = std::max(0.0, 2 / (1 + std::exp(-lead_)) - 1);
  belief_ = trust * wanted * better;
  for (float& followed : estimate.followed) {
    const float sure = std::min(followed, surest);
    followed = static_cast<float>(belief_) * sure / (1 - sure);
  }
  return std::move(estimate.followed);
}

}  // namespace sailmap
