// Signatures and matches as bytes, numbers with the lowest byte first: a map of 100 000 places holds two
// million regions, and a row for each would take most of the time of loading it.
#pragma once

#include <vector>

#include "rows.hpp"
#include "sailmap/signature.hpp"
#include "sailmap/similarity.hpp"

namespace sailmap::store {

// Of each region 48 bytes: x, y as 16-bit integers, saliency and the ten numbers as 32-bit floats.
Blob regions_to_bytes(const std::vector<Region>& regions);
// Of a layout its 32 words of 64 bits, then of each region 86 bytes: x, y and varied as 16-bit, the ten words
// as 64-bit integers. Empty for a place that was not described.
Blob place_to_bytes(const PlaceDescriptor& place);
// Of each match 16 bytes: query and candidate as 32-bit integers, the distance as a 64-bit float.
Blob matches_to_bytes(const std::vector<RegionMatch>& matches);

// Throw Error, without the name of the file, when the bytes are no such thing.
Signature signature_from_row(const SignatureRow& row);
std::vector<RegionMatch> matches_from_bytes(const Blob& bytes);

}  // namespace sailmap::store
