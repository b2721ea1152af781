#include "json_map.hpp"

#include "io/file_reading.hpp"
#include "io/json_numbers.hpp"
#include "map/map_json.hpp"
#include "sailmap/error.hpp"

namespace sailmap::store {

StoredMap read_json_map(const std::filesystem::path& path) {
  using nlohmann::ordered_json;
  std::ifstream in = io::open_for_reading(path);
  try {
    const ordered_json json = ordered_json::parse(in);
    if (json.at("format") != "sailmap map") throw Error("not a sailmap map");
    const int version = io::whole_number(json.at("version"));
    if (version != 1) {
      throw Error("map format version " + std::to_string(version) + ", this program reads version 1 of JSON");
    }
    return {map_from_json(json.at("map")), json.at("frontend").get<std::string>()};
  } catch (const ordered_json::exception& fault) {
    throw Error(path.string() + ": not a sailmap map, or a damaged one: " + fault.what());
  } catch (const Error& fault) {
    throw Error(path.string() + ": " + fault.what());
  }
}

}  // namespace sailmap::store
