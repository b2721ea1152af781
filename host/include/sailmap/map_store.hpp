// Where a map lives on disk, behind one interface.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "sailmap/topological_map.hpp"

namespace sailmap {

// A map and what it was made with.
struct StoredMap {
  TopologicalMap map;
  std::string frontend;
};

class MapStore {
 public:
  virtual ~MapStore() = default;
  [[nodiscard]] virtual bool exists() const = 0;
  // Throws Error, naming the file and the fault, when it cannot be read or is no map.
  [[nodiscard]] virtual StoredMap load() const = 0;
  // Replaces the file whole or not at all. Throws Error when it cannot be written.
  virtual void save(const TopologicalMap& map, const std::string& frontend) = 0;
};

std::unique_ptr<MapStore> open_map_store(const std::filesystem::path& path);

}  // namespace sailmap
