// Which regions of two images have the same surroundings.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "differing_bits.hpp"
#include "sailmap/context.hpp"
#include "varied_maps.hpp"

namespace sailmap {
namespace {

// Lengths in parts of the diagonal of an image of 4:3.
constexpr float width = 0.8F;
constexpr float height = 0.6F;
constexpr float search_radius = 0.6F;
constexpr float displacement_tolerance = 0.15F;
// Contexts of other places agree by chance up to about here.
constexpr float chance_agreement = 0.13F;
constexpr int context_bits = ContextRegion::side * ContextRegion::side;

struct Point {
  float x, y;
};

Point position(const ContextRegion& region) {
  return {static_cast<float>(region.x) / 65535 * width, static_cast<float>(region.y) / 65535 * height};
}

float squared(const Point& a, const Point& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

std::vector<Point> positions(const PlaceDescriptor& place) {
  std::vector<Point> out;
  for (const ContextRegion& region : place.regions) out.push_back(position(region));
  return out;
}

struct Agreements {
  std::size_t queries, candidates;
  std::vector<float> values;  // -1 .. 1; below that where the regions are too far apart
  [[nodiscard]] float at(std::size_t i, std::size_t j) const { return values[i * candidates + j]; }
};

// The candidate's regions side by side, with the maps that say something in them.
context::BitRows side_by_side(const PlaceDescriptor& candidate) {
  context::BitRows rows(feature_count, candidate.regions.size());
  for (std::size_t j = 0; j < candidate.regions.size(); ++j) {
    const ContextRegion& region = candidate.regions[j];
    for (std::size_t m = 0; m < feature_count; ++m) {
      rows.set(m, j, region.bits[m], ((region.varied >> m) & 1U) != 0 ? ~std::uint64_t{0} : 0);
    }
  }
  return rows;
}

void compare(const PlaceDescriptor& query, const PlaceDescriptor& candidate, const std::vector<Point>& from,
             const std::vector<Point>& to, std::vector<float>& values) {
  const context::BitRows rows = side_by_side(candidate);
  std::vector<std::uint64_t> differing(rows.lanes);
  const unsigned comparable =
      context::comparable_maps(context::varied_maps(query.layout), context::varied_maps(candidate.layout));
  std::size_t k = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const ContextRegion& a = query.regions[i];
    const unsigned maps = a.varied & comparable;
    const int maps_of_a = context::maps_in(maps);
    context::differing_bits(a.bits.data(), maps, rows, differing.data());
    for (std::size_t j = 0; j < to.size(); ++j, ++k) {
      if (squared(from[i], to[j]) > search_radius * search_radius) continue;
      const ContextRegion& b = candidate.regions[j];
      const int maps_of_both = context::maps_in(maps & b.varied);
      if (maps_of_both == 0) continue;
      const int agreeing = context_bits * maps_of_both - 2 * static_cast<int>(differing[j]);
      const int maps_of_b = context::maps_in(b.varied & comparable);
      values[k] = static_cast<float>(agreeing) / (context_bits * context::mean_of_maps(maps_of_a, maps_of_b));
    }
  }
}

// Pairs each of which is the other's best, with an agreement that is no chance; `distance` is 1 - agreement.
std::vector<RegionMatch> mutual_matches(const Agreements& agreements) {
  std::vector<std::size_t> best_query(agreements.candidates, 0);
  for (std::size_t i = 1; i < agreements.queries; ++i) {
    for (std::size_t j = 0; j < agreements.candidates; ++j) {
      if (agreements.at(i, j) > agreements.at(best_query[j], j)) best_query[j] = i;
    }
  }
  std::vector<RegionMatch> matches;
  for (std::size_t i = 0; i < agreements.queries; ++i) {
    std::size_t best = 0;
    for (std::size_t j = 1; j < agreements.candidates; ++j) {
      if (agreements.at(i, j) > agreements.at(i, best)) best = j;
    }
    const float agreement = agreements.at(i, best);
    if (best_query[best] == i && agreement > chance_agreement) {
      matches.push_back({static_cast<int>(i), static_cast<int>(best), 1 - static_cast<double>(agreement)});
    }
  }
  return matches;
}

float strength(const RegionMatch& match) { return static_cast<float>(1 - match.distance) - chance_agreement; }

}  // namespace

MatchResult match_contexts(const PlaceDescriptor& query, const PlaceDescriptor& candidate) {
  MatchResult out;
  if (query.regions.empty() || candidate.regions.empty()) return out;
  const std::vector<Point> from = positions(query);
  const std::vector<Point> to = positions(candidate);
  Agreements agreements{from.size(), to.size(), std::vector<float>(from.size() * to.size(), -2.0F)};
  compare(query, candidate, from, to, agreements.values);
  const std::vector<RegionMatch> matches = mutual_matches(agreements);

  std::vector<Point> displacements;
  for (const RegionMatch& match : matches) {
    const Point& a = from[static_cast<std::size_t>(match.query)];
    const Point& b = to[static_cast<std::size_t>(match.candidate)];
    displacements.push_back({b.x - a.x, b.y - a.y});
  }
  constexpr float reach = displacement_tolerance * displacement_tolerance;
  float most = 0;
  std::size_t common = 0;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    float sum = 0;
    for (std::size_t other = 0; other < matches.size(); ++other) {
      if (squared(displacements[k], displacements[other]) < reach) sum += strength(matches[other]);
    }
    if (sum > most) {
      most = sum;
      common = k;
    }
  }
  for (std::size_t k = 0; k < matches.size(); ++k) {
    if (squared(displacements[common], displacements[k]) < reach) out.matches.push_back(matches[k]);
  }
  const auto pairs = static_cast<float>(from.size() * to.size());
  out.similarity = static_cast<double>(most / (std::sqrt(pairs) * (1 - chance_agreement)));
  return out;
}

}  // namespace sailmap
