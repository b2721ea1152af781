// SQL on a map file behind the library's back, through SQLite itself.
#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <filesystem>
#include <string>

namespace sailmap::testing {

// The first column of the last row, or nothing.
inline std::string run_sql(const std::filesystem::path& path, const std::string& sql) {
  sqlite3* database = nullptr;
  EXPECT_EQ(::sqlite3_open(path.c_str(), &database), SQLITE_OK);
  std::string last;
  const auto keep = [](void* out, int count, char** values, char**) {
    if (count > 0 && values[0] != nullptr) *static_cast<std::string*>(out) = values[0];
    return 0;
  };
  EXPECT_EQ(::sqlite3_exec(database, sql.c_str(), keep, &last, nullptr), SQLITE_OK)
      << ::sqlite3_errmsg(database);
  EXPECT_EQ(::sqlite3_close(database), SQLITE_OK);
  return last;
}

}  // namespace sailmap::testing
