#include "schema.hpp"

#include <array>
#include <map>
#include <string>

#include "sailmap/error.hpp"

namespace sailmap::store {
namespace {

constexpr int application_id = 0x534C4D50;  // "SLMP", in the file's header

struct Table {
  const char* name;
  const char* columns;
};

// Columns as in rows.hpp, where they are explained. STRICT: a column holds its type alone.
constexpr std::array<Table, 8> tables = {{
    {"map", "sailmap TEXT NOT NULL, frontend TEXT NOT NULL, parameters TEXT NOT NULL"},
    {"session",
     "source TEXT NOT NULL, started REAL NOT NULL, first_image INTEGER NOT NULL, images INTEGER NOT NULL, "
     "skipped INTEGER NOT NULL, seconds REAL NOT NULL"},
    {"node", "first_image INTEGER NOT NULL"},
    {"image",
     "name TEXT NOT NULL, time REAL, node INTEGER NOT NULL, new_node INTEGER NOT NULL, is_view INTEGER NOT "
     "NULL"},
    {"signature",
     "width INTEGER NOT NULL, height INTEGER NOT NULL, regions BLOB NOT NULL, place BLOB NOT NULL"},
    {"detection",
     "reason TEXT NOT NULL, best_node INTEGER NOT NULL, best_similarity REAL NOT NULL, runner_up_node "
     "INTEGER NOT NULL, runner_up_similarity REAL NOT NULL, matches BLOB NOT NULL"},
    {"edge", "from_node INTEGER NOT NULL, to_node INTEGER NOT NULL, kind TEXT NOT NULL"},
    {"thumbnail", "jpeg BLOB NOT NULL"},
}};

std::string create_statement(const Table& table) {
  return std::string("CREATE TABLE ") + table.name + " (id INTEGER PRIMARY KEY, " + table.columns +
         ", checksum INTEGER NOT NULL) STRICT";
}

int number(SQLite::Database& database, const std::string& pragma) {
  return database.execAndGet("PRAGMA " + pragma).getInt();
}

}  // namespace

void create_schema(SQLite::Database& database) {
  for (const Table& table : tables) database.exec(create_statement(table));
  database.exec("PRAGMA application_id = " + std::to_string(application_id));
  database.exec("PRAGMA user_version = " + std::to_string(schema_version));
}

bool is_blank(SQLite::Database& database) {
  return database.execAndGet("SELECT count(*) FROM sqlite_schema").getInt() == 0 &&
         number(database, "application_id") == 0;
}

void check_schema(SQLite::Database& database) {
  if (is_blank(database)) throw Error("not a sailmap map, or a damaged one: it is empty");
  if (number(database, "application_id") != application_id) throw Error("not a sailmap map");
  const int version = number(database, "user_version");
  if (version != schema_version) {
    throw Error("map format version " + std::to_string(version) + ", this program reads versions 1 to " +
                std::to_string(schema_version));
  }
  std::map<std::string, std::string> expected;
  for (const Table& table : tables) expected[table.name] = create_statement(table);
  std::map<std::string, std::string> found;
  SQLite::Statement statement(database, "SELECT name, sql FROM sqlite_schema");
  while (statement.executeStep())
    found[statement.getColumn(0).getString()] = statement.getColumn(1).getString();
  if (found != expected) throw Error("not a sailmap map, or a damaged one: its tables are others");
}

}  // namespace sailmap::store
