#include "varied_maps.hpp"

#include <cstddef>
#include <cstdint>

namespace sailmap::context {
namespace {

constexpr std::size_t colour = 1;  // of kind_of_feature

constexpr unsigned colour_maps() {
  unsigned out = 0;
  for (std::size_t map = 0; map < feature_count; ++map) {
    if (kind_of_feature[map] == colour) out |= 1U << map;
  }
  return out;
}

}  // namespace

unsigned varied_maps(const Layout& layout) {
  std::uint64_t low = 0;
  std::uint64_t high = 0;
  for (const auto& column : layout.words) {
    low |= column[0];
    high |= column[1];
  }
  unsigned out = 0;
  for (int row = 0; row < Layout::rows; ++row) {
    out |= static_cast<unsigned>(low) & all_maps;
    low = (low >> feature_count) | (high << (64 - feature_count));
    high >>= feature_count;
  }
  return out;
}

unsigned comparable_maps(unsigned varied, unsigned varied_of_other) {
  constexpr unsigned colours = colour_maps();
  const bool grey = (varied & colours) == 0 || (varied_of_other & colours) == 0;
  return grey ? all_maps & ~colours : all_maps;
}

}  // namespace sailmap::context
