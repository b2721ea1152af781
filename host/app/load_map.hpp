#pragma once

#include <filesystem>

#include "sailmap/map_store.hpp"

namespace sailmap::app {

// Throws Error, naming the file, when there is none or it is no map.
StoredMap load_map(const std::filesystem::path& path);

}  // namespace sailmap::app
