// The tables of a map file and the version that they have.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

namespace sailmap::store {

// Version 1 was a JSON document (json_map.hpp), which is read still, and replaced by a database when it is
// written to.
inline constexpr int schema_version = 2;

// In a transaction of the caller. Throws SQLite::Exception.
void create_schema(SQLite::Database& database);

// Throws Error, without the name of the file, when the database is none of ours, of a newer version, or has
// other tables, triggers or views than those of its version.
void check_schema(SQLite::Database& database);

// Whether nothing was ever created in it: the writer ended before its first commit.
bool is_blank(SQLite::Database& database);

}  // namespace sailmap::store
