// A map file written anew beside its place and renamed: nobody ever sees half of one.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>
#include <functional>

namespace sailmap::store {

// Calls `write` with a new file of our schema inside a transaction. What stood at `path` is replaced when all
// went well and else as it was; the caller holds its lock. Throws Error without the name of the file, or
// SQLite::Exception.
void replace_file(const std::filesystem::path& path, const std::function<void(SQLite::Database&)>& write);

// A database and all that SQLite puts beside it.
void remove_with_log(const std::filesystem::path& path);

}  // namespace sailmap::store
