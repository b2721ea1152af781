#include "load_map.hpp"

#include "sailmap/error.hpp"

namespace sailmap::app {

StoredMap load_map(const std::filesystem::path& path) {
  const MapStore store(path);
  if (!store.exists()) throw Error(path.string() + ": no such file");
  return store.load();
}

}  // namespace sailmap::app
