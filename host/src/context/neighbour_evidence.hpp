// What the candidates next to one in the route say of it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sailmap/place_descriptor.hpp"

namespace sailmap::context {

// Of each proposed candidate the mean of its evidence and that of the candidates before and behind it, as far
// as these show the same place. `candidates` are in the order of the route, `proposed` some of them, each
// once, `evidence` is theirs; the evidence of all others is 0. One number a proposed candidate.
std::vector<double> mean_along_route(std::span<const PlaceDescriptor* const> candidates,
                                     const std::vector<std::size_t>& proposed,
                                     const std::vector<double>& evidence);

}  // namespace sailmap::context
