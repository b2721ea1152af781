// One layout against many.
#pragma once

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
  BitRows shifted_;            // a lane for each way to lay a candidate against the query
  std::vector<int> compared_;  // bits, of each lane
};

}  // namespace sailmap::context
