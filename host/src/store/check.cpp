#include "connection.hpp"
#include "json_map.hpp"
#include "read_map.hpp"
#include "sailmap/map_maintenance.hpp"
#include "schema.hpp"

namespace sailmap {

using namespace store;

namespace {

constexpr std::size_t most_faults = 100;

class Checker {
 public:
  explicit Checker(SQLite::Database& database) : database_(database) {}

  // Does a part of the check; what it throws is a fault.
  template <class Work>
  void attempt(const Work& work) {
    try {
      work();
    } catch (const SQLite::Exception& fault) {
      add(explain(fault));
    } catch (const Error& fault) {
      add(fault.what());
    }
  }

  void check_structure() {
    attempt([&] {
      SQLite::Statement statement(database_, "PRAGMA integrity_check(100)");
      while (statement.executeStep()) {
        const std::string line = statement.getColumn(0).getString();
        if (line != "ok") add("structure: " + line);
      }
    });
  }

  template <class Row>
  void check_rows() {
    attempt([&] {
      SQLite::Statement statement(database_, select_statement<Row>("ORDER BY id"));
      while (statement.executeStep()) attempt([&] { static_cast<void>(read_row<Row>(statement)); });
    });
  }

  MapCheck take() { return std::move(check_); }
  [[nodiscard]] bool is_sound() const { return check_.faults.empty(); }
  void add(const std::string& fault) {
    if (check_.faults.size() < most_faults) check_.faults.push_back(Error(fault).what());
  }
  void count(const TopologicalMap& map) {
    check_.images = map.images();
    check_.nodes = static_cast<int>(map.nodes().size());
  }

 private:
  SQLite::Database& database_;
  MapCheck check_;
};

MapCheck check_database(SQLite::Database& database) {
  Checker checker(database);
  checker.attempt([&] { check_schema(database); });
  checker.check_structure();
  checker.check_rows<MapRow>();
  checker.check_rows<SessionRow>();
  checker.check_rows<NodeRow>();
  checker.check_rows<ImageRow>();
  checker.check_rows<SignatureRow>();
  checker.check_rows<DetectionRow>();
  checker.check_rows<EdgeRow>();
  checker.check_rows<ThumbnailRow>();
  if (checker.is_sound()) checker.attempt([&] { checker.count(read_map(database).map); });
  return checker.take();
}

}  // namespace

MapCheck check_map(const std::filesystem::path& path) {
  if (!is_there(path)) throw Error(path.string() + ": no such file, or an empty one");
  if (is_json(path)) {
    const StoredMap stored = read_json_map(path);
    return {{}, stored.map.images(), static_cast<int>(stored.map.nodes().size())};
  }
  try {
    const Connection connection = connect_to_read(path);
    const SQLite::Transaction moment(*connection);
    return check_database(*connection);
  } catch (const SQLite::Exception& fault) {
    return {{explain(fault)}, 0, 0};
  }
}

}  // namespace sailmap
