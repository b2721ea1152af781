// Method `context`: the layout proposes candidates, the contexts of salient regions decide
// (docs/recognition.md).
#pragma once

#include <span>
#include <vector>

#include "sailmap/place_descriptor.hpp"
#include "sailmap/signature.hpp"
#include "sailmap/similarity.hpp"

namespace sailmap {

// Agreement of two layouts under the best shift of up to 4 columns and 1 row: -1 .. 1; 1 for the same image.
// Only maps that have a bit in both are compared; one that has in either alone counts against it, but for the
// colours where one image is grey. 0 without any map to compare.
double layout_agreement(const Layout& query, const Layout& candidate);

// Regions matched, of one displacement, and how alike their contexts are: `similarity` is 0 where nothing
// matches, near 1 for the same image. Not quite symmetric: ties among regions go to the first.
MatchResult match_contexts(const PlaceDescriptor& query, const PlaceDescriptor& candidate);

// The calibrated score, 0 .. 1: one half where the evidence is twice the typical one of the image's
// candidates.
double context_score(double evidence, double typical);

// The 40 candidates of best layout agreement are scored; all others get 0. `candidates` in the order in which
// they were passed: those before and behind one that show the same place count with it. One score, 0 .. 1, a
// candidate; 0 throughout when the query has no region.
std::vector<float> score_contexts(const PlaceDescriptor& query,
                                  std::span<const PlaceDescriptor* const> candidates);

// Two images alone, without others to compare with: match_contexts with a calibrated similarity.
MatchResult match_places(const PlaceDescriptor& query, const PlaceDescriptor& candidate);

// The signature with the regions that match_places numbers in place of the paper's (without their ten
// numbers).
Signature with_context_regions(const Signature& signature);

}  // namespace sailmap
