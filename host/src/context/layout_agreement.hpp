// One layout against many.
#pragma once

#include <array>
#include <vector>

#include "differing_bits.hpp"
#include "sailmap/place_descriptor.hpp"

namespace sailmap::context {

class LayoutQuery {
 public:
  explicit LayoutQuery(const Layout& query);
  // See sailmap::layout_agreement.
  [[nodiscard]] double agreement(const Layout& candidate) const;

 private:
  unsigned varied_;            // a bit for each map that says something in the query
  BitRows shifted_;            // a lane for each way to lay a candidate against the query
  std::vector<int> compared_;  // cells, of each lane
  std::vector<std::array<int, feature_count>> set_;  // bits of the query's maps among these
};

}  // namespace sailmap::context
