// Spec section 10: which regions of two images are the same, under both geometric constraints.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "sailmap/error.hpp"
#include "sailmap/similarity.hpp"

namespace sailmap {
namespace {

double diagonal(const Signature& signature) { return std::hypot(signature.width, signature.height); }

double descriptor_distance(const Descriptor& a, const Descriptor& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

struct Displacement {
  double dx, dy;
};

// Members of a set as bits; as many words as the matches need.
using Bits = std::vector<std::uint64_t>;

bool test(const Bits& bits, std::size_t i) { return ((bits[i / 64] >> (i % 64)) & 1U) != 0; }
void set(Bits& bits, std::size_t i) { bits[i / 64] |= std::uint64_t{1} << (i % 64); }
void clear(Bits& bits, std::size_t i) { bits[i / 64] &= ~(std::uint64_t{1} << (i % 64)); }

int count(const Bits& bits) {
  int total = 0;
  for (const std::uint64_t word : bits) total += std::popcount(word);
  return total;
}

// Exact search for the largest set of pairwise agreeing matches (a maximum clique), branch and bound. Matches
// are tried in order, so that of equally good sets the first is kept.
class LargestAgreement {
 public:
  LargestAgreement(const std::vector<RegionMatch>& matches, const std::vector<Displacement>& displacements,
                   double tolerance)
      : matches_(matches), words_((matches.size() + 63) / 64), agrees_(matches.size(), Bits(words_)) {
    for (std::size_t a = 0; a < matches.size(); ++a) {
      for (std::size_t b = 0; b < matches.size(); ++b) {
        const double dx = displacements[a].dx - displacements[b].dx;
        const double dy = displacements[a].dy - displacements[b].dy;
        if (a != b && dx * dx + dy * dy <= tolerance * tolerance) set(agrees_[a], b);
      }
    }
  }

  std::vector<RegionMatch> find() {
    Bits all(words_);
    for (std::size_t i = 0; i < matches_.size(); ++i) set(all, i);
    extend(all, 0, 0);
    std::vector<RegionMatch> out;
    for (const std::size_t i : best_) out.push_back(matches_[i]);
    return out;
  }

 private:
  void extend(Bits candidates, std::size_t first, double distance) {
    keep_if_better(distance);
    for (std::size_t i = first; i < matches_.size(); ++i) {
      if (!test(candidates, i)) continue;
      const std::size_t reachable = chosen_.size() + static_cast<std::size_t>(count(candidates));
      if (reachable < best_.size()) return;
      // Equal size can only win by a smaller sum of distances.
      if (reachable == best_.size() && distance >= best_distance_) return;
      Bits narrowed = candidates;
      for (std::size_t w = 0; w < words_; ++w) narrowed[w] &= agrees_[i][w];
      chosen_.push_back(i);
      extend(std::move(narrowed), i + 1, distance + matches_[i].distance);
      chosen_.pop_back();
      clear(candidates, i);
    }
  }

  void keep_if_better(double distance) {
    if (chosen_.size() > best_.size() || (chosen_.size() == best_.size() && distance < best_distance_)) {
      best_ = chosen_;
      best_distance_ = distance;
    }
  }

  const std::vector<RegionMatch>& matches_;
  std::size_t words_;
  std::vector<Bits> agrees_;
  std::vector<std::size_t> chosen_;
  std::vector<std::size_t> best_;
  double best_distance_ = 0;
};

}  // namespace

std::vector<RegionMatch> nearest_matches(const Signature& query, const Signature& candidate,
                                         const MatchConfig& config) {
  const double radius = config.search_radius * diagonal(query);
  std::vector<RegionMatch> matches;
  for (std::size_t i = 0; i < query.regions.size(); ++i) {
    const Region& from = query.regions[i];
    RegionMatch nearest{static_cast<int>(i), -1, 0};
    for (std::size_t j = 0; j < candidate.regions.size(); ++j) {
      const Region& to = candidate.regions[j];
      const double dx = from.x - to.x;
      const double dy = from.y - to.y;
      if (dx * dx + dy * dy >= radius * radius) continue;
      const double distance = descriptor_distance(from.descriptor, to.descriptor);
      if (nearest.candidate < 0 || distance < nearest.distance) {
        nearest.candidate = static_cast<int>(j);
        nearest.distance = distance;
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
    displacements.push_back({to.x - from.x, to.y - from.y});
  }
  const double tolerance = config.displacement_tolerance * diagonal(query);
  return LargestAgreement(matches, displacements, tolerance).find();
}

}  // namespace sailmap
