// Version 1 of the map file: one JSON document. It is read, and no longer written.
#pragma once

#include <filesystem>

#include "sailmap/map_store.hpp"

namespace sailmap::store {

// Throws Error, naming the file, when it cannot be read or is no map.
StoredMap read_json_map(const std::filesystem::path& path);

}  // namespace sailmap::store
