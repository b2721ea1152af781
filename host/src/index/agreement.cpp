#include "agreement.hpp"

#include <algorithm>
#include <cmath>

#include "kernels.hpp"

namespace sailmap::index {
namespace {

// Costs are rounded down by this part of themselves, far above what arithmetic loses.
constexpr double slack = 1e-5;
// Differences of two admissible displacements fit in signed bytes, their squares in 16 bits.
constexpr double furthest = 63;
constexpr double largest_spread = 32766;
// As many as squares of 64 times their number have 16 bits.
constexpr std::size_t most_regions = 31;

std::int16_t place_of(const RegionCode& code) {
  const auto column = static_cast<std::uint8_t>(code[column_byte]);
  const auto row = static_cast<std::uint8_t>(code[row_byte]);
  return static_cast<std::int16_t>(column | row << 8);
}

}  // namespace

void Batch::add(const Block& block, std::size_t lane) {
  const auto count = static_cast<std::size_t>(block.counts[lane]);
  if (count > slots()) codes.resize(count * slot_bytes);
  const auto* from = reinterpret_cast<const std::uint16_t*>(block.codes.data()) + lane;
  auto* to = reinterpret_cast<std::uint16_t*>(codes.data()) + images;
  for (std::size_t slot = 0; slot < count; ++slot) {
    for (std::size_t row = 0; row < code_rows; ++row) to[row * batch_images] = from[row * block_images];
    from += code_rows * block_images;
    to += code_rows * batch_images;
  }
  columns.add(block.columns[lane / group_images]);
  counts[images++] = block.counts[lane];
}

void Batch::clear() {
  images = 0;
  counts.fill(0);
  columns.clear();
}

AgreementQuery::AgreementQuery(const Signature& query, const MatchConfig& config)
    : squared(config.method == Method::paper_weighted),
      cost_unit(squared ? 64 : 2048),
      kinds_(kinds_shared(query)) {
  const double diagonal = std::hypot(query.width, query.height);
  const double radius = config.search_radius * diagonal;
  const double tolerance = config.displacement_tolerance * diagonal;
  const PositionGrid grid(query.width, query.height);
  const double cell = grid.step * grid.step;
  // match() compares squared pixels, whole numbers, with these squares; between exact positions they are
  // whole numbers of cells.
  const double offset = std::floor((std::ceil(radius * radius) - 1) / cell);
  const double spread = std::floor(std::floor(tolerance * tolerance) / cell);
  usable_ = kinds_ != no_shares && query.regions.size() <= most_regions && grid.step == 4 &&
            offset <= furthest * furthest;
  if (!usable_) return;
  largest_squared_offset = static_cast<std::int16_t>(offset);
  largest_squared_spread = static_cast<std::int16_t>(std::min(spread, largest_spread));
  for (const Region* region : by_column(query)) {
    usable_ = usable_ && is_exact(*region, grid);
    const double error = both_code_errors(*region) / step * (1 + slack);
    regions.push_back(
        {screen_region(*region, grid, radius), place_of(encode(*region, grid)), static_cast<float>(error)});
  }
}

void AgreementQuery::set_threshold(double threshold) {
  const double weight = squared ? static_cast<double>(regions.size()) : 1;
  constexpr double enough = 1e30;  // no similarity is infinite here: no distance still costs nothing
  cost_of_step = static_cast<float>(std::min(step * weight * threshold * cost_unit * (1 - slack), enough));
}

std::uint32_t AgreementQuery::passing(const Batch& batch) {
  work_.slots.resize(std::max(work_.slots.size(), batch.slots()));
  work_.nearest.resize(regions.size());
  return agreeing_images(batch, *this, work_);
}

}  // namespace sailmap::index
