// The peaks of the saliency map, many and dense: the regions of the method `context`.
#pragma once

#include <vector>

#include "sailmap/signature.hpp"

namespace sailmap::context {

// As find_peaks with a box of 2 (width / 40) + 1 by 2 (height / 30) + 1 samples, down to a sixteenth of the
// highest peak, but in time that hardly grows with their number. In the map's own unit.
std::vector<Peak> salient_peaks(const Map& saliency, int max_regions);

}  // namespace sailmap::context
