// The map file of today: one JSON document, replaced whole at each save.
#include <system_error>
#include <utility>

#include "io/file_reading.hpp"
#include "io/json_numbers.hpp"
#include "map_json.hpp"
#include "sailmap/error.hpp"
#include "sailmap/file.hpp"
#include "sailmap/map_store.hpp"

namespace sailmap {
namespace {

using nlohmann::ordered_json;

constexpr const char* format_name = "sailmap map";
constexpr int format_version = 1;

class JsonStore : public MapStore {
 public:
  explicit JsonStore(std::filesystem::path path) : path_(std::move(path)) {}

  [[nodiscard]] bool exists() const override {
    std::error_code unknown;
    return std::filesystem::exists(path_, unknown);
  }

  [[nodiscard]] StoredMap load() const override {
    std::ifstream in = io::open_for_reading(path_);
    try {
      const ordered_json json = ordered_json::parse(in);
      if (json.at("format") != format_name) throw Error("not a sailmap map");
      const int version = io::whole_number(json.at("version"));
      if (version != format_version) {
        throw Error("map format version " + std::to_string(version) + ", this program reads version " +
                    std::to_string(format_version));
      }
      return {map_from_json(json.at("map")), json.at("frontend").get<std::string>()};
    } catch (const ordered_json::exception& fault) {
      throw Error(path_.string() + ": not a sailmap map, or a damaged one: " + fault.what());
    } catch (const Error& fault) {
      throw Error(path_.string() + ": " + fault.what());
    }
  }

  void save(const TopologicalMap& map, const std::string& frontend) override {
    const ordered_json json = {
        {"format", format_name}, {"version", format_version}, {"frontend", frontend}, {"map", to_json(map)}};
    // Names of images are paths, and those may hold any bytes: what is not UTF-8 is replaced rather than
    // fatal.
    write_file(path_, [&json](std::ostream& out) {
      out << json.dump(-1, ' ', false, ordered_json::error_handler_t::replace) << '\n';
    });
  }

 private:
  std::filesystem::path path_;
};

}  // namespace

std::unique_ptr<MapStore> open_map_store(const std::filesystem::path& path) {
  return std::make_unique<JsonStore>(path);
}

}  // namespace sailmap
