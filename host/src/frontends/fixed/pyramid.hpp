// Spec sections 2 and 3: from the image to levels 2 to 4 of intensity and colours.
#pragma once

#include <array>
#include <cstdint>

#include "padded_plane.hpp"
#include "sailmap/hls/geometry.hpp"
#include "sailmap/ref/plane.hpp"
#include "samples.hpp"

namespace sailmap::fixed {

// One channel of one level on its way to the next. Rows come in pairs; of the vertical filter [1 4 6 4 1] the
// pairs before are kept as two rows of sums, so that a level is never held as a whole.
struct Reduction {
  PaddedPlane<std::int32_t> sums;  // row 0: of the next row to come out; row 1: of the one after it
};

class Pyramid {
 public:
  // Samples this far beyond the border of a level that is kept are its edge, replicated.
  static constexpr int border = 16;

  // All levels of `image`, whose sides are valid. Rows pass through the levels as they come, so that they are
  // still in the first-level cache.
  void compute(const ImageView& image);

  // Levels base_level to top_level.
  [[nodiscard]] const PaddedPlane<Sample>& plane(int level, Channel channel) const {
    return levels_[static_cast<std::size_t>(level)].planes[channel];
  }

 private:
  struct Level {
    int width = 0;
    int height = 0;
    // Below the base level the last two rows, from there on all.
    std::array<PaddedPlane<Sample>, channel_count> planes;
    std::array<Reduction, channel_count> reductions;  // to the next level
  };

  void resize(int width, int height);
  Sample* row(int level, std::size_t channel, int y);
  void row_is_complete(int level, int y);
  // Rows 2 pair and 2 pair + 1 of a level; row pair - 1 of the next comes out.
  void reduce_pair(int level, int even_y, int odd_y);
  void reduce_last(int level, int y);

  std::array<Level, hls::geometry::top_level + 1> levels_;
};

}  // namespace sailmap::fixed
