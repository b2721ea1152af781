// Which loops are worth a picture, and what matched in them.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "pictures.hpp"
#include "subject.hpp"

namespace sailmap::report {

// Why a loop is shown.
struct Pick {
  std::size_t loop = 0;  // in Subject::loops
  const char* why = "";  // "wrong", "strongest", "weakest" or "doubtful"
};

// At most `most` loops, each once, the most worth seeing first: those known to be wrong (up to a third), then
// in turn the strongest, the weakest, and the most doubtful, those of least margin.
std::vector<Pick> pick_loops(const Subject& subject, std::size_t most);

// The view of the known place that is most like the image; the first when there is only one or its regions
// are not known.
int best_view(const Loop& loop, const Signature& image, const StoredSignatures& stored,
              const MatchConfig& config);

// The image of the known place that is shown, and what both images are called.
struct PairNames {
  int view = 0;
  std::string image;
  std::string place;
};

// {"view", "matches": [image's region, place's region, distance, ...], "regions": boxes of the image,
// "place_regions": boxes of the place}. Throws Error when the recorded matches are of other regions than the
// images have today.
nlohmann::ordered_json pair_of(const Loop& loop, const PairNames& names, const Look& image, const Look& place,
                               const Subject& subject);

}  // namespace sailmap::report
