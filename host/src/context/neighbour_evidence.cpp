// Images of a route that show the same place are seen again together. A candidate whose neighbours look like
// it without looking like the query is alike by chance: by its lamps, say, where the corridor is another.
#include "neighbour_evidence.hpp"

#include <algorithm>
#include <map>

#include "sailmap/context.hpp"

namespace sailmap::context {
namespace {

// Against the candidate's own evidence, of a neighbour that surely shows the same place.
constexpr double weight = 0.6;

// Part of that weight, by how alike two neighbours are: different places are by up to 0.05.
double part_shared(double similarity) { return std::clamp((similarity - 0.05) / 0.1, 0.0, 1.0); }

class Route {
 public:
  explicit Route(std::span<const PlaceDescriptor* const> candidates) : candidates_(candidates) {}

  // How much of a place candidates `earlier` and the next one share: 0 .. 1.
  double shared_with_next(std::size_t earlier) {
    const auto [known, is_new] = shared_.try_emplace(earlier, 0.0);
    if (is_new) {
      known->second =
          part_shared(match_contexts(*candidates_[earlier], *candidates_[earlier + 1]).similarity);
    }
    return known->second;
  }

 private:
  std::span<const PlaceDescriptor* const> candidates_;
  std::map<std::size_t, double> shared_;
};

}  // namespace

std::vector<double> mean_along_route(std::span<const PlaceDescriptor* const> candidates,
                                     const std::vector<std::size_t>& proposed,
                                     const std::vector<double>& evidence) {
  std::vector<double> of_candidate(candidates.size(), 0.0);
  for (std::size_t k = 0; k < proposed.size(); ++k) of_candidate[proposed[k]] = evidence[k];
  Route route(candidates);
  std::vector<double> means;
  means.reserve(proposed.size());
  for (const std::size_t i : proposed) {
    double sum = of_candidate[i];
    double weights = 1;
    const auto count = [&](double shared, std::size_t neighbour) {
      sum += weight * shared * of_candidate[neighbour];
      weights += weight * shared;
    };
    if (i > 0) count(route.shared_with_next(i - 1), i - 1);
    if (i + 1 < candidates.size()) count(route.shared_with_next(i), i + 1);
    means.push_back(sum / weights);
  }
  return means;
}

}  // namespace sailmap::context
