// What match() demands.
#pragma once

#include "sailmap/similarity.hpp"

namespace sailmap {

// Throws Error when the images differ in size.
void check_same_size(const Signature& query, const Signature& candidate);

// Throws Error when a number is out of range.
void check_match_config(const MatchConfig& config);

}  // namespace sailmap
