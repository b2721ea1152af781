#include "layout_agreement.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "sailmap/context.hpp"
#include "varied_maps.hpp"

namespace sailmap {
namespace context {
namespace {

using Column = std::array<std::uint64_t, 2>;
constexpr int row_bits = static_cast<int>(feature_count);

// The column moved down by a row, or up; what leaves it is lost.
Column down(const Column& c) { return {c[0] << row_bits, (c[1] << row_bits) | (c[0] >> (64 - row_bits))}; }
Column up(const Column& c) { return {(c[0] >> row_bits) | (c[1] << (64 - row_bits)), c[1] >> row_bits}; }

Column both(const Column& a, const Column& b) { return {a[0] & b[0], a[1] & b[1]}; }
Column either(const Column& a, const Column& b) { return {a[0] | b[0], a[1] | b[1]}; }

// The bits of these maps, in all rows.
Column bits_of(unsigned maps) {
  Column out{};
  for (int row = 0; row < Layout::rows; ++row) out = either(down(out), {maps, 0});
  return out;
}

int count(const Column& bits) { return std::popcount(bits[0]) + std::popcount(bits[1]); }

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

LayoutQuery::LayoutQuery(const Layout& query)
    : varied_(varied_maps(query)), shifted_(layout_words, shifts), set_(shifts) {
  std::array<Column, feature_count> bits_of_map{};
  for (std::size_t map = 0; map < feature_count; ++map) bits_of_map[map] = bits_of(1U << map);
  for (const Shift& shift : row_shifts) {
    const Column mask = both(shift.move(bits_of(varied_)), bits_of(varied_));
    for (int dx = -reach; dx <= reach; ++dx) {
      const std::size_t lane = compared_.size();
      for (int x = std::max(0, -dx); x < std::min(Layout::columns, Layout::columns - dx); ++x) {
        const Column moved = shift.move(query.words[static_cast<std::size_t>(x)]);
        const auto word = 2 * static_cast<std::size_t>(x + dx);
        shifted_.set(word, lane, moved[0], mask[0]);
        shifted_.set(word + 1, lane, moved[1], mask[1]);
        for (std::size_t map = 0; map < feature_count; ++map) {
          set_[lane][map] += count(both(moved, bits_of_map[map]));
        }
      }
      compared_.push_back((Layout::columns - std::abs(dx)) * shift.rows);
    }
  }
}

double LayoutQuery::agreement(const Layout& candidate) const {
  static_assert(sizeof(candidate.words) == layout_words * sizeof(std::uint64_t));
  static_assert(layout_words == 32);
  const unsigned varied = varied_maps(candidate);
  const unsigned both = varied & varied_;
  if (both == 0) return 0;
  std::array<std::uint64_t, shifts + BitRows::granule> differing;
  differing_bits(candidate.words.front().data(), ~std::uint32_t{0}, shifted_, differing.data());
  const unsigned query_alone = varied_ & ~varied;  // differs by what the query has set, but says nothing
  const int maps = maps_in(both);
  double best = -1;
  for (std::size_t i = 0; i < shifts; ++i) {
    int different = static_cast<int>(differing[i]);
    for (unsigned left = query_alone; left != 0; left &= left - 1) {
      different -= set_[i][static_cast<std::size_t>(std::countr_zero(left))];
    }
    best = std::max(best, 1 - 2.0 * different / (compared_[i] * maps));
  }
  const unsigned comparable = comparable_maps(varied_, varied);
  const float mean = mean_of_maps(maps_in(varied_ & comparable), maps_in(varied & comparable));
  return best * (maps / static_cast<double>(mean));
}

}  // namespace context

double layout_agreement(const Layout& query, const Layout& candidate) {
  return context::LayoutQuery(query).agreement(candidate);
}

}  // namespace sailmap
