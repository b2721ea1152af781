// Opening a map file, alone when it is to be written, and what SQLite says in words that a user understands.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>
#include <memory>
#include <string>

#include "sailmap/error.hpp"

namespace sailmap::store {

using Connection = std::unique_ptr<SQLite::Database>;

// A place of the method context takes 7.6 kB: on pages of this size, bytes, it lies in one piece.
inline constexpr int page_size = 16384;

// The fault in plain words, one line, without the name of the file.
std::string explain(const SQLite::Exception& fault);

// Does `work` and puts the name of the file before the message of what it throws.
template <class Work>
auto with_file(const std::filesystem::path& path, const Work& work) {
  try {
    return work();
  } catch (const SQLite::Exception& fault) {
    throw Error(path.string() + ": " + explain(fault));
  } catch (const Error& fault) {
    throw Error(path.string() + ": " + fault.what());
  }
}

// Whether the file is no database and begins as a JSON document does: a map of version 1. A database is
// opened by SQLite alone: POSIX drops the locks of a process on a file when it closes any descriptor of it.
bool is_json(const std::filesystem::path& path);

// Whether there is a file with something in it.
bool is_there(const std::filesystem::path& path);

// Sees what was committed when a statement begins; works while another program writes, and in a folder that
// cannot be written. Throws SQLite::Exception.
Connection connect_to_read(const std::filesystem::path& path);

// Throws SQLite::Exception.
Connection connect_to_write(const std::filesystem::path& path);

// Before the first transaction that writes: commits then survive the end of the program and of the machine's
// power. Throws SQLite::Exception.
void begin_writing(SQLite::Database& database);

// Leaves one plain file, without a write-ahead log beside it, unless another program reads it just now.
void leave_one_file(SQLite::Database& database);

}  // namespace sailmap::store
