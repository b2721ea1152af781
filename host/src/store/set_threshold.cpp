#include "connection.hpp"
#include "json_map.hpp"
#include "map/config_json.hpp"
#include "read_map.hpp"
#include "sailmap/map_maintenance.hpp"
#include "sailmap/map_store.hpp"
#include "schema.hpp"
#include "write_lock.hpp"
#include "write_rows.hpp"

namespace sailmap {

using namespace store;

namespace {

void set_in_json(const std::filesystem::path& path, double threshold) {
  const StoredMap stored = read_json_map(path);
  const TopologicalMap& map = stored.map;
  MapConfig config = map.config();
  config.detection.threshold = threshold;
  MapStore(path).save(
      TopologicalMap(config, map.nodes(), map.edges(), map.history(), map.active(), map.sessions()),
      stored.frontend);
}

}  // namespace

void set_threshold(const std::filesystem::path& path, double threshold) {
  if (!is_there(path)) throw Error(path.string() + ": no such file");
  if (is_json(path)) return set_in_json(path, threshold);
  with_file(path, [&] {
    const WriteLock lock(path);
    const Connection connection = connect_to_write(path);
    begin_writing(*connection);
    SQLite::Transaction transaction(*connection);
    check_schema(*connection);
    MapRow row = read_map_row(*connection);
    MapConfig config = config_of(row);
    config.detection.threshold = threshold;
    row.parameters = to_json(config).dump();
    RowWriter(*connection).put(row);
    transaction.commit();
    leave_one_file(*connection);
  });
}

}  // namespace sailmap
