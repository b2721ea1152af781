#include "sailmap/route_model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sailmap {
namespace {

// Before anything was learned: an image moves on by about one candidate (a second lap at the speed of the
// first), perhaps by several (images dropped, a faster lap). Worth as much as six images of learning.
constexpr std::array<double, 7> usual_steps = {0.15, 0.33, 0.2, 0.12, 0.08, 0.07, 0.05};
constexpr double worth_of_usual_steps = 6;

// What a path is thought to break off at first is worth as much as ten images of learning.
constexpr double worth_of_first_breaks = 10;
constexpr double fewest_breaks = 0.02, most_breaks = 0.98;
// The same for what must not be done where paths break: hardly ever, until the first break is seen.
constexpr double rare_breaks = 0.03;
constexpr double worth_of_rare_breaks = 2;

// That images follow a route must be shown: one sequence in ten does.
constexpr double usual_order = 0.1;

// How much of the posterior within two candidates counts for a candidate: truth is about that wide.
constexpr std::array<float, 3> neighbour_weights = {1.0F, 0.9F, 0.7F};

// to[c] += weight * from[c - shift]
void add_shifted(std::vector<float>& to, const std::vector<float>& from, double weight,
                 std::ptrdiff_t shift) {
  const auto w = static_cast<float>(weight);
  const auto begin = std::max<std::ptrdiff_t>(0, shift);
  const auto end =
      std::min(static_cast<std::ptrdiff_t>(to.size()), static_cast<std::ptrdiff_t>(from.size()) + shift);
  for (std::ptrdiff_t c = begin; c < end; ++c) {
    to[static_cast<std::size_t>(c)] += w * from[static_cast<std::size_t>(c - shift)];
  }
}

double product(const std::vector<float>& a, std::span<const float> b) {
  return std::inner_product(
      a.begin(), a.end(), b.begin(), 0.0, [](double x, double y) { return x + y; },
      [](float x, float y) { return static_cast<double>(x) * y; });
}

double sum_of(const std::vector<float>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

std::vector<float> with_neighbours(const std::vector<float>& values) {
  std::vector<float> out(values.size(), 0.0F);
  for (std::size_t k = 0; k < neighbour_weights.size(); ++k) {
    const auto shift = static_cast<std::ptrdiff_t>(k);
    add_shifted(out, values, neighbour_weights[k], shift);
    if (shift > 0) add_shifted(out, values, neighbour_weights[k], -shift);
  }
  return out;
}

}  // namespace

RouteModel::RouteModel(int images, double first_breaks)
    : first_breaks_(first_breaks),
      keep_steps_(1 - 1 / (2.0 * images)),
      keep_breaks_(1 - 1 / (5.0 * images)),
      change_of_order_(1 / (5.0 * images)),
      order_(usual_order) {}

void RouteModel::lose() {
  forward_.clear();
  backward_.clear();
  fresh_.clear();
}

double RouteModel::trust() const { return std::max(0.0, 2 * order_ - 1); }

double RouteModel::observed_breaks() const {
  return (breaks_ + worth_of_rare_breaks * rare_breaks) / (counted_ + worth_of_rare_breaks);
}

double RouteModel::break_rate() const {
  const double rate = (breaks_ + worth_of_first_breaks * first_breaks_) / (counted_ + worth_of_first_breaks);
  return std::clamp(rate, fewest_breaks, most_breaks);
}

RouteModel::Steps RouteModel::step_probabilities() const {
  Steps out{};
  for (std::size_t k = 0; k < steps; ++k) out[k] = step_counts_[k] + worth_of_usual_steps * usual_steps[k];
  const double sum = std::accumulate(out.begin(), out.end(), 0.0);
  for (double& value : out) value /= sum;
  return out;
}

RouteModel::Forecast RouteModel::forecast(const Steps& probabilities,
                                          std::span<const float> likelihoods) const {
  const std::size_t count = likelihoods.size();
  Forecast out{std::vector<float>(count, 0.0F), std::vector<float>(count, 0.0F), {}};
  std::vector<float> fresh(count, 0.0F);
  for (std::size_t k = 0; k < steps; ++k) {
    const auto shift = static_cast<std::ptrdiff_t>(k);
    add_shifted(out.forward, forward_, probabilities[k], shift);
    add_shifted(out.backward, backward_, probabilities[k], -shift);
  }
  out.confirmed = out.forward;
  add_shifted(out.confirmed, out.backward, 1, 0);
  // Where a path begins, it may go either way.
  for (std::size_t k = 0; k < steps; ++k) {
    const auto shift = static_cast<std::ptrdiff_t>(k);
    add_shifted(out.forward, fresh_, probabilities[k] / 2, shift);
    add_shifted(out.backward, fresh_, probabilities[k] / 2, -shift);
  }
  return out;
}

RouteModel::Steps RouteModel::explained_by(const Steps& probabilities,
                                           std::span<const float> likelihoods) const {
  std::vector<float> forward = forward_;
  std::vector<float> backward = backward_;
  add_shifted(forward, fresh_, 0.5, 0);
  add_shifted(backward, fresh_, 0.5, 0);
  Steps out{};
  for (std::size_t k = 0; k < steps; ++k) {
    const auto shift = static_cast<std::ptrdiff_t>(k);
    std::vector<float> moved(likelihoods.size(), 0.0F);
    add_shifted(moved, forward, probabilities[k], shift);
    add_shifted(moved, backward, probabilities[k], -shift);
    out[k] = product(moved, likelihoods);
  }
  return out;
}

// Only what followed a route can tell of its steps and breaks.
void RouteModel::learn(const Steps& explained, double went_on) {
  const double sum = std::accumulate(explained.begin(), explained.end(), 0.0);
  for (std::size_t k = 0; k < steps; ++k) {
    const double share = sum > 0 ? explained[k] / sum : 0;
    step_counts_[k] = keep_steps_ * step_counts_[k] + order_ * went_on * share;
  }
  const double weight = trust();
  const double keep = 1 - (1 - keep_breaks_) * weight;
  breaks_ = keep * breaks_ + weight * (1 - went_on);
  counted_ = keep * counted_ + weight;
}

// Paths that are one image old are as much attested as that image showed its place.
double RouteModel::attested(const Forecast& ahead, std::span<const float> likelihoods) const {
  const double all = product(ahead.forward, likelihoods) + product(ahead.backward, likelihoods);
  const double older = product(ahead.confirmed, likelihoods);
  return all > 0 ? (attested_paths_ * older + attested_fresh_ * (all - older)) / all : 0;
}

// Whether images follow a route may change now and then, and returns to what is usual.
void RouteModel::judge_order(double expected) {
  order_ =
      order_ * (1 - change_of_order_) + (1 - order_) * change_of_order_ * usual_order / (1 - usual_order);
  order_ = order_ * expected / (order_ * expected + 1 - order_);
}

RouteModel::Estimate RouteModel::advance(std::span<const float> likelihoods, int admissible, double shown) {
  const std::size_t count = likelihoods.size();
  const bool first = forward_.empty();
  const double breaks = first ? 1 : break_rate();
  const double anywhere = 1.0 / admissible;
  const Steps probabilities = step_probabilities();
  Forecast ahead = forecast(probabilities, likelihoods);
  const Steps explained = explained_by(probabilities, likelihoods);
  const double on_route = (1 - breaks) * std::accumulate(explained.begin(), explained.end(), 0.0);
  Estimate out;
  if (!first) out.on_map = std::min(1.0, sum_of(ahead.forward) + sum_of(ahead.backward));
  // What breaks off, and what runs off the map's ends, may be anywhere.
  const double off_route = 1 - (1 - breaks) * out.on_map;
  out.expected = on_route + off_route;
  // One forecast that held proves little, since images that follow each other err alike: paths that began
  // with the last image count as being anywhere too.
  const double spread = 1 - (1 - breaks) * sum_of(ahead.confirmed);
  out.prior.resize(count);
  out.followed.resize(count);
  for (std::size_t c = 0; c < count; ++c) {
    const double confirmed = (1 - breaks) * ahead.confirmed[c];
    out.prior[c] = static_cast<float>(confirmed / anywhere + spread);
    out.followed[c] = static_cast<float>(confirmed * likelihoods[c] / out.expected);
  }
  out.followed = with_neighbours(out.followed);
  if (!first) {
    learn(explained, 1 - breaks / out.expected);
    // What runs off the map follows no route in it.
    judge_order(on_route + breaks);
  }
  out.attested = attested(ahead, likelihoods);
  attested_paths_ = out.attested + (1 - out.attested) * shown;
  attested_fresh_ = shown;
  const auto on = static_cast<float>((1 - breaks) / out.expected);
  const auto begun = static_cast<float>(off_route * anywhere / out.expected);
  fresh_.resize(count);
  for (std::size_t c = 0; c < count; ++c) {
    ahead.forward[c] *= on * likelihoods[c];
    ahead.backward[c] *= on * likelihoods[c];
    fresh_[c] = begun * likelihoods[c];
  }
  forward_ = std::move(ahead.forward);
  backward_ = std::move(ahead.backward);
  return out;
}

}  // namespace sailmap
