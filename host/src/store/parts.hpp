// A map taken apart, as its file holds it, for tools that keep some of it: recovery and pruning.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <optional>
#include <string>
#include <vector>

#include "rows.hpp"
#include "sailmap/topological_map.hpp"

namespace sailmap::store {

struct ImageParts {
  ImageRow image;
  DetectionRow detection;
  std::optional<SignatureRow> signature;
  std::optional<ThumbnailRow> thumbnail;
};

// Numbers of nodes, images and edges need not be without gaps here.
struct MapParts {
  MapRow map;
  std::vector<SessionRow> sessions;
  std::vector<ImageParts> images;  // rising
  std::vector<EdgeRow> edges;
};

// Drops what does not hold together and renumbers the rest without gaps: first images whose node has no view
// left that can be compared, then edges and candidates that lead to no node, and sessions without an image.
// An image that lost the node it was found at is no loop closure any more.
MapParts made_whole(MapParts parts);

// Into an empty file of our schema, in a transaction of the caller. `parts` are whole.
void write_parts(SQLite::Database& database, const MapParts& parts);

// All of a sound file. Throws Error without the name of the file.
MapParts read_parts(SQLite::Database& database);

}  // namespace sailmap::store
