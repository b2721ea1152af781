#include "estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "kernels.hpp"

namespace sailmap::index {
namespace {

// What single precision may lose, with room to spare: a part of the whole.
constexpr double slack = 1e-4;
// Below this all whole numbers are exact in single precision.
constexpr double whole_numbers = 1 << 24;

}  // namespace

Estimator::Estimator(const Signature& query, const MatchConfig& config) : config_(config) {
  const double diagonal = std::hypot(query.width, query.height);
  const double radius = config.search_radius * diagonal;
  const double tolerance = config.displacement_tolerance * diagonal;
  // match() compares whole numbers with these squares.
  const double offset = std::ceil(radius * radius) - 1;
  const double spread = std::floor(tolerance * tolerance);
  exact_ = offset < whole_numbers && spread < whole_numbers;
  lanes_.largest_squared_offset = static_cast<float>(std::min(offset, whole_numbers));
  lanes_.largest_squared_spread = static_cast<float>(std::min(spread, whole_numbers));

  lanes_.count = query.regions.size();
  std::vector<std::size_t> region_of_lane(lanes_.count);
  std::iota(region_of_lane.begin(), region_of_lane.end(), std::size_t{0});
  std::sort(region_of_lane.begin(), region_of_lane.end(),
            [&](std::size_t a, std::size_t b) { return query.regions[a].x > query.regions[b].x; });
  const std::size_t padded = (lanes_.count + lane_padding - 1) / lane_padding * lane_padding;
  constexpr float nowhere = 1e18F;
  lanes_.x.assign(padded, nowhere);
  lanes_.y.assign(padded, nowhere);
  lanes_.descriptor.fill(std::vector<float>(padded));
  lanes_.order.resize(lanes_.count);
  work_.numbers.resize(5 * padded);
  for (std::size_t lane = 0; lane < lanes_.count; ++lane) {
    const Region& region = query.regions[region_of_lane[lane]];
    lanes_.x[lane] = region.x;
    lanes_.y[lane] = region.y;
    for (std::size_t k = 0; k < feature_count; ++k) lanes_.descriptor[k][lane] = region.descriptor[k];
    lanes_.order[region_of_lane[lane]] = lane;
  }
  const int reach = static_cast<int>(std::min(std::ceil(radius), 1e6));
  for (std::size_t lane = 0; lane < lanes_.count; lane += lane_padding) {
    const std::size_t last = std::min(lane + lane_padding, lanes_.count) - 1;
    lanes_.reaches.push_back(
        {static_cast<int>(lanes_.x[last]) - reach, static_cast<int>(lanes_.x[lane]) + reach});
  }
}

double Estimator::operator()(const Signature& candidate) {
  if (!exact_) return std::numeric_limits<double>::infinity();
  const ConsistentMatches found =
      consistent_matches(lanes_, candidate.regions.data(), candidate.regions.size(), work_);
  if (found.ambiguous) return std::numeric_limits<double>::infinity();
  if (found.count == 0) return 0;
  double weight = 1;
  if (config_.method == Method::paper_weighted) {
    weight = found.count / static_cast<double>(std::max(lanes_.count, candidate.regions.size()));
  }
  const double similarity = found.count / static_cast<double>(found.sum);  // infinite: capped
  return weight * std::min(similarity, config_.similarity_cap) * (1 + slack);
}

}  // namespace sailmap::index
