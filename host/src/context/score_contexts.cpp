// One image against many: the layout proposes, the contexts decide.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <vector>

#include "layout_agreement.hpp"
#include "neighbour_evidence.hpp"
#include "sailmap/context.hpp"

namespace sailmap {
namespace {

constexpr std::size_t proposals = 40;

struct Spread {
  double mean = 0;
  double deviation = 0;
};

Spread spread_of(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  Spread out;
  out.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double value : values) squares += (value - out.mean) * (value - out.mean);
  out.deviation = std::sqrt(squares / count);
  return out;
}

// The best ones, the first on ties.
std::vector<std::size_t> best_of(const std::vector<double>& agreements) {
  std::vector<std::size_t> order(agreements.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto end = order.begin() + static_cast<std::ptrdiff_t>(std::min(proposals, order.size()));
  std::partial_sort(order.begin(), end, order.end(), [&](std::size_t a, std::size_t b) {
    return agreements[a] != agreements[b] ? agreements[a] > agreements[b] : a < b;
  });
  order.erase(end, order.end());
  return order;
}

// The typical evidence among candidates of another place.
constexpr double usual = 0.08;

// What stands for the rivals' evidence: that of the candidate a quarter down the list, drawn towards what is
// usual where there are few.
double typical_evidence(std::vector<double> evidence) {
  constexpr double weight_of_usual = 20;
  std::erase_if(evidence, [](double e) { return !(e > 0); });
  if (evidence.empty()) return usual;
  const auto quarter = evidence.begin() + static_cast<std::ptrdiff_t>(evidence.size() / 4);
  std::nth_element(evidence.begin(), quarter, evidence.end(), std::greater<>());
  const auto count = static_cast<double>(evidence.size());
  return (count * *quarter + weight_of_usual * usual) / (count + weight_of_usual);
}

}  // namespace

double context_score(double evidence, double typical) {
  constexpr double floor = 0.05;
  constexpr double even = 2;  // so many times the typical evidence scores one half
  const double ratio = evidence / (typical + floor) / even;
  const double odds = ratio * ratio * ratio;
  return odds / (odds + 1);
}

std::vector<float> score_contexts(const PlaceDescriptor& query,
                                  std::span<const PlaceDescriptor* const> candidates) {
  std::vector<float> scores(candidates.size(), 0.0F);
  if (candidates.empty() || query.regions.empty()) return scores;
  const context::LayoutQuery layout(query.layout);
  std::vector<double> agreements;
  agreements.reserve(candidates.size());
  for (const PlaceDescriptor* other : candidates) agreements.push_back(layout.agreement(other->layout));
  const Spread spread = spread_of(agreements);
  constexpr double weight = 0.2;
  const std::vector<std::size_t> proposed = best_of(agreements);
  std::vector<double> evidence;
  for (const std::size_t i : proposed) {
    // Few candidates, or all alike, have no spread worth the name.
    const double prominence = (agreements[i] - spread.mean) / (spread.deviation + 0.01);
    evidence.push_back(match_contexts(query, *candidates[i]).similarity *
                       (1 + weight * std::clamp(prominence, -2.0, 4.0)));
  }
  const double typical = typical_evidence(evidence);
  const std::vector<double> supported = context::mean_along_route(candidates, proposed, evidence);
  for (std::size_t k = 0; k < proposed.size(); ++k) {
    scores[proposed[k]] = static_cast<float>(context_score(supported[k], typical));
  }
  return scores;
}

MatchResult match_places(const PlaceDescriptor& query, const PlaceDescriptor& candidate) {
  // Neither rivals nor neighbours to compare with: more is asked for.
  constexpr double usual_of_a_pair = 0.105;
  MatchResult out = match_contexts(query, candidate);
  out.similarity = context_score(out.similarity, usual_of_a_pair);
  return out;
}

Signature with_context_regions(const Signature& signature) {
  Signature out = signature;
  out.regions.clear();
  for (const ContextRegion& region : signature.place.get().regions) {
    const auto pixel = [](int position, int side) {
      return static_cast<std::int16_t>(std::lround(position * side / 65535.0));
    };
    out.regions.push_back({pixel(region.x, signature.width), pixel(region.y, signature.height), 0, {}});
  }
  return out;
}

}  // namespace sailmap
