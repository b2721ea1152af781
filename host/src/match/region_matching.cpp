// Spec section 10: which regions of two images are the same, under both geometric constraints.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sailmap/similarity.hpp"

namespace sailmap {
namespace {

double diagonal(const Signature& signature) { return std::hypot(signature.width, signature.height); }

double squared_distance(const Descriptor& a, const Descriptor& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = static_cast<double>(a[i]) - b[i];
    sum += difference * difference;
  }
  return sum;
}

struct Displacement {
  double dx, dy;
};

bool agree(const Displacement& a, const Displacement& b, double tolerance) {
  const double dx = a.dx - b.dx;
  const double dy = a.dy - b.dy;
  return dx * dx + dy * dy <= tolerance * tolerance;
}

// How many displacements agree with this one, itself included.
std::ptrdiff_t supporters(const std::vector<Displacement>& all, const Displacement& of, double tolerance) {
  return std::count_if(all.begin(), all.end(),
                       [&](const Displacement& d) { return agree(d, of, tolerance); });
}

}  // namespace

std::vector<RegionMatch> nearest_matches(const Signature& query, const Signature& candidate,
                                         const MatchConfig& config) {
  const double radius = config.search_radius * diagonal(query);
  std::vector<RegionMatch> matches;
  for (std::size_t i = 0; i < query.regions.size(); ++i) {
    const Region& from = query.regions[i];
    RegionMatch nearest{static_cast<int>(i), -1, 0};
    double least = 0;  // squared distance of the nearest
    for (std::size_t j = 0; j < candidate.regions.size(); ++j) {
      const Region& to = candidate.regions[j];
      const double dx = from.x - to.x;
      const double dy = from.y - to.y;
      if (dx * dx + dy * dy >= radius * radius) continue;
      const double squared = squared_distance(from.descriptor, to.descriptor);
      if (nearest.candidate >= 0 && squared >= least) continue;  // most of them, and spared the root
      const double distance = std::sqrt(squared);
      if (nearest.candidate < 0 || distance < nearest.distance) {
        nearest.candidate = static_cast<int>(j);
        nearest.distance = distance;
        least = squared;
      }
    }
    if (nearest.candidate >= 0) matches.push_back(nearest);
  }
  return matches;
}

std::vector<RegionMatch> consistent_matches(const Signature& query, const Signature& candidate,
                                            const std::vector<RegionMatch>& matches,
                                            const MatchConfig& config) {
  std::vector<Displacement> displacements;
  for (const RegionMatch& match : matches) {
    const Region& from = query.regions[static_cast<std::size_t>(match.query)];
    const Region& to = candidate.regions[static_cast<std::size_t>(match.candidate)];
    displacements.push_back({static_cast<double>(to.x - from.x), static_cast<double>(to.y - from.y)});
  }
  const double tolerance = config.displacement_tolerance * diagonal(query);
  if (displacements.empty()) return {};
  const Displacement* common = &displacements.front();
  std::ptrdiff_t most = 0;
  for (const Displacement& displacement : displacements) {
    const std::ptrdiff_t support = supporters(displacements, displacement, tolerance);
    if (support > most) {
      most = support;
      common = &displacement;
    }
  }
  std::vector<RegionMatch> consistent;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    if (agree(displacements[k], *common, tolerance)) consistent.push_back(matches[k]);
  }
  return consistent;
}

}  // namespace sailmap
