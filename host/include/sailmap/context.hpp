// Method `context`: the layout proposes candidates, the contexts of salient regions decide
// (docs/recognition.md).
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "sailmap/place_descriptor.hpp"
#include "sailmap/similarity.hpp"

namespace sailmap {

// Agreement of two layouts under the best shift of up to 4 columns and 1 row: -1 .. 1; 1 for the same image.
double layout_agreement(const Layout& query, const Layout& candidate);

// Regions matched, of one displacement, and how alike their contexts are: `similarity` is 0 where nothing
// matches, near 1 for the same image. Not quite symmetric: ties among regions go to the first.
MatchResult match_contexts(const PlaceDescriptor& query, const PlaceDescriptor& candidate);

// The calibrated score, 0 .. 1: one half where the evidence is twice the typical one of the image's
// candidates.
double context_score(double evidence, double typical);

// The 40 candidates of best layout agreement are scored; all others get 0. `candidate(i)` gives the
// descriptor that layouts[i] belongs to. One score a candidate.
std::vector<float> score_contexts(const PlaceDescriptor& query, std::span<const Layout> layouts,
                                  const std::function<const PlaceDescriptor&(std::size_t)>& candidate);

}  // namespace sailmap
