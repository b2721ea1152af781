#include "threshold_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <string>

#include "sailmap/error.hpp"

namespace sailmap::app {
namespace {

constexpr double risk = 0.05;

// With the fewest digits, at least `low` and below `high`, near the middle.
double short_number_between(double low, double high) {
  const double middle = low + (high - low) / 2;
  for (int digits = 2; digits < 17; ++digits) {
    const double rounded = std::stod(fmt::format("{:.{}g}", middle, digits));
    if (rounded >= low && rounded < high) return rounded;
  }
  return middle < high ? middle : low;
}

// Scores fall along the curve. Below the last one all is detected.
double threshold_at(const std::vector<CurvePoint>& curve, std::size_t point) {
  const double score = curve[point].threshold;
  const double next = point + 1 < curve.size() ? curve[point + 1].threshold : std::min(0.0, score - 1);
  return short_number_between(next, score);
}

}  // namespace

ThresholdChoice choose_threshold(const std::vector<CurvePoint>& curve, int queries_with_match,
                                 double precision) {
  if (curve.empty()) throw Error("no query was compared with anything: there is no curve");
  std::size_t chosen = curve.size();
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (curve[i].precision < precision) continue;
    if (chosen == curve.size() || curve[i].recall > curve[chosen].recall) chosen = i;
  }
  if (chosen == curve.size()) {
    const auto best = std::ranges::max_element(curve, {}, &CurvePoint::precision);
    throw Error(fmt::format("a precision of {:g} is never reached; the highest is {:.4g}, at similarity {:g}",
                            precision, best->precision, best->threshold));
  }
  ThresholdChoice out;
  out.threshold = threshold_at(curve, chosen);
  out.precision = curve[chosen].precision;
  out.recall = curve[chosen].recall;
  out.right = static_cast<int>(std::lround(out.recall * queries_with_match));
  out.detections = static_cast<int>(std::lround(out.right / out.precision));
  if (out.detections > 0) {
    out.precision_at_least =
        boost::math::binomial_distribution<>::find_lower_bound_on_p(out.detections, out.right, risk);
  }
  out.needed = static_cast<int>(std::ceil(std::log(risk) / std::log(std::min(precision, 0.99))));
  return out;
}

}  // namespace sailmap::app
