#include "layout_agreement.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>

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

// For each way to lay the candidate's rows against the query's: the query's words, and which bits are
// compared.
struct Shifted {
  Layout layout;
  Column mask{};
  int rows = 0;
};

Shifted shifted(const Layout& query, Column (*move)(const Column&), int rows) {
  Shifted out;
  out.mask = both(move(all_rows()), all_rows());
  out.rows = rows;
  for (std::size_t x = 0; x < query.words.size(); ++x) {
    out.layout.words[x] = both(move(query.words[x]), out.mask);
  }
  return out;
}

}  // namespace

struct LayoutQuery::Rows {
  std::array<Shifted, 3> shifts;
};

LayoutQuery::LayoutQuery(const Layout& query)
    : rows_(std::make_unique<Rows>(
          Rows{{shifted(
                    query, [](const Column& c) { return c; }, Layout::rows),
                shifted(query, down, Layout::rows - 1), shifted(query, up, Layout::rows - 1)}})) {}

LayoutQuery::~LayoutQuery() = default;

SAILMAP_POPCOUNT_CLONES
double LayoutQuery::agreement(const Layout& candidate) const {
  double best = -1;
  for (const Shifted& query : rows_->shifts) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const int first = std::max(0, -dx);
      const int last = std::min(Layout::columns, Layout::columns - dx);
      int differing = 0;
      for (int x = first; x < last; ++x) {
        const auto& a = query.layout.words[static_cast<std::size_t>(x)];
        const auto& b = candidate.words[static_cast<std::size_t>(x + dx)];
        differing +=
            std::popcount(a[0] ^ (b[0] & query.mask[0])) + std::popcount(a[1] ^ (b[1] & query.mask[1]));
      }
      const int compared = (last - first) * query.rows * row_bits;
      best = std::max(best, 1 - 2.0 * differing / compared);
    }
  }
  return best;
}

}  // namespace context

double layout_agreement(const Layout& query, const Layout& candidate) {
  return context::LayoutQuery(query).agreement(candidate);
}

}  // namespace sailmap
