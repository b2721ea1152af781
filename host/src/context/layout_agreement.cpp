#include "layout_agreement.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "sailmap/context.hpp"

namespace sailmap {
namespace context {
namespace {

using Column = std::array<std::uint64_t, 2>;
constexpr int row_bits = static_cast<int>(feature_count);

// The column moved down by a row, or up; what leaves it is lost.
Column down(const Column& c) { return {c[0] << row_bits, (c[1] << row_bits) | (c[0] >> (64 - row_bits))}; }
Column up(const Column& c) { return {(c[0] >> row_bits) | (c[1] << (64 - row_bits)), c[1] >> row_bits}; }

Column all_rows() {
  Column out{};
  for (int bit = 0; bit < Layout::rows * row_bits; ++bit) {
    out[static_cast<std::size_t>(bit) / 64] |= std::uint64_t{1} << (bit % 64);
  }
  return out;
}

Column both(const Column& a, const Column& b) { return {a[0] & b[0], a[1] & b[1]}; }

// How the query's rows are moved, and how many are compared then. Each of these with the columns moved aside
// is a way to lay a candidate against the query.
struct Shift {
  Column (*move)(const Column&);
  int rows;  // compared
};
constexpr std::array<Shift, 3> row_shifts = {
    {{[](const Column& c) { return c; }, Layout::rows}, {down, Layout::rows - 1}, {up, Layout::rows - 1}}};
constexpr int reach = 4;  // columns to each side
constexpr std::size_t shifts = row_shifts.size() * (2 * reach + 1);
constexpr std::size_t layout_words = 2 * std::size_t{Layout::columns};

}  // namespace

LayoutQuery::LayoutQuery(const Layout& query) : shifted_(layout_words, shifts) {
  for (const Shift& shift : row_shifts) {
    const Column mask = both(shift.move(all_rows()), all_rows());
    for (int dx = -reach; dx <= reach; ++dx) {
      const std::size_t lane = compared_.size();
      for (int x = std::max(0, -dx); x < std::min(Layout::columns, Layout::columns - dx); ++x) {
        const Column moved = shift.move(query.words[static_cast<std::size_t>(x)]);
        const auto word = 2 * static_cast<std::size_t>(x + dx);
        shifted_.set(word, lane, moved[0], mask[0]);
        shifted_.set(word + 1, lane, moved[1], mask[1]);
      }
      compared_.push_back((Layout::columns - std::abs(dx)) * shift.rows * row_bits);
    }
  }
}

double LayoutQuery::agreement(const Layout& candidate) const {
  static_assert(sizeof(candidate.words) == layout_words * sizeof(std::uint64_t));
  static_assert(layout_words == 32);
  std::array<std::uint64_t, shifts + BitRows::granule> differing;
  differing_bits(candidate.words.front().data(), ~std::uint32_t{0}, shifted_, differing.data());
  double best = -1;
  for (std::size_t i = 0; i < shifts; ++i) {
    best = std::max(best, 1 - 2.0 * static_cast<int>(differing[i]) / compared_[i]);
  }
  return best;
}

}  // namespace context

double layout_agreement(const Layout& query, const Layout& candidate) {
  return context::LayoutQuery(query).agreement(candidate);
}

}  // namespace sailmap
