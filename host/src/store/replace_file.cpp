#include "replace_file.hpp"

#include <unistd.h>

#include <array>
#include <system_error>

#include "connection.hpp"
#include "schema.hpp"

namespace sailmap::store {

void remove_with_log(const std::filesystem::path& path) {
  for (const char* ending : {"", "-wal", "-shm", "-journal"}) {
    std::error_code ignored;
    std::filesystem::remove(path.string() + ending, ignored);
  }
}

namespace {

// A log that a killed writer left would be applied to the file that takes the old one's place.
void take_in_log(const std::filesystem::path& path) {
  std::error_code unknown;
  if (std::filesystem::exists(path.string() + "-wal", unknown)) leave_one_file(*connect_to_write(path));
}

}  // namespace

void replace_file(const std::filesystem::path& path, const std::function<void(SQLite::Database&)>& write) {
  take_in_log(path);
  const std::filesystem::path part = path.string() + ".part" + std::to_string(::getpid());
  remove_with_log(part);
  try {
    {
      const Connection connection = connect_to_write(part);
      begin_writing(*connection);
      SQLite::Transaction transaction(*connection);
      create_schema(*connection);
      write(*connection);
      transaction.commit();
      leave_one_file(*connection);
    }
    std::error_code failed;
    std::filesystem::rename(part, path, failed);
    if (failed) throw Error("cannot be written: " + failed.message());
  } catch (...) {
    remove_with_log(part);
    throw;
  }
}

}  // namespace sailmap::store
