// A map from the tables of its file.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <optional>
#include <vector>

#include "row_io.hpp"
#include "sailmap/map_store.hpp"

namespace sailmap::store {

// All of them throw Error without the name of the file, or SQLite::Exception. A consistent map comes of one
// transaction: the caller's.
StoredMap read_map(SQLite::Database& database);
MapRow read_map_row(SQLite::Database& database);
MapConfig config_of(const MapRow& row);
std::vector<SessionRow> read_sessions(SQLite::Database& database);
Detection detection_from_row(const DetectionRow& row);

// In the order of their numbers.
template <class Row, class Use>
void for_each_row(SQLite::Database& database, const Use& use) {
  SQLite::Statement statement(database, select_statement<Row>("ORDER BY id"));
  while (statement.executeStep()) use(read_row<Row>(statement));
}

// Rows of one table by their number.
template <class Row>
class RowFinder {
 public:
  explicit RowFinder(SQLite::Database& database)
      : statement_(database, select_statement<Row>("WHERE id = ?")) {}
  std::optional<Row> find(int id) {
    statement_.reset();
    statement_.bind(1, id);
    if (!statement_.executeStep()) return std::nullopt;
    return read_row<Row>(statement_);
  }

 private:
  SQLite::Statement statement_;
};

}  // namespace sailmap::store
