#include "connection.hpp"

#include <sqlite3.h>

#include <fstream>
#include <string_view>
#include <system_error>

namespace sailmap::store {
namespace {

constexpr int busy_milliseconds = 10000;  // a checkpoint of another connection may take that long

// What an untrusted file could do through SQLite's own means stays off.
void harden(SQLite::Database& database) {
  ::sqlite3_db_config(database.getHandle(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  database.exec("PRAGMA trusted_schema = OFF");
  database.exec("PRAGMA cell_size_check = ON");
}

// Of the path as a URI, whose special characters are escaped.
std::string uri_of(const std::filesystem::path& path) {
  static constexpr std::string_view digits = "0123456789ABCDEF";
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(path).string()) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '%' || c == '?' || c == '#' || byte < 0x21 || byte > 0x7E) {
      uri += {'%', digits[byte >> 4U], digits[byte & 15U]};
    } else {
      uri += c;
    }
  }
  return uri;
}

bool has_log(const std::filesystem::path& path) {
  std::error_code unknown;
  const auto size = std::filesystem::file_size(path.string() + "-wal", unknown);
  return !unknown && size > 0;
}

}  // namespace

std::string explain(const SQLite::Exception& fault) {
  switch (fault.getErrorCode()) {
    case SQLITE_NOTADB:
      return "not a sailmap map, or a damaged one";
    case SQLITE_CORRUPT:
      return "damaged; 'sailmap map recover' saves what can be read";
    case SQLITE_FULL:
      return "the disk is full";
    case SQLITE_READONLY:
      return "cannot be written";
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "another program is writing this map";
    case SQLITE_CANTOPEN:
      return "cannot be opened";
    case SQLITE_IOERR:
      return fault.getExtendedErrorCode() == SQLITE_IOERR_SHORT_READ
                 ? "truncated; 'sailmap map recover' saves what can be read"
                 : "cannot be read or written: " + std::string(fault.what());
    case SQLITE_PERM:
    case SQLITE_AUTH:
      return "no permission";
    default:
      return fault.what();
  }
}

bool is_there(const std::filesystem::path& path) {
  std::error_code unknown;
  const auto size = std::filesystem::file_size(path, unknown);
  // A folder or device is there too: whoever opens it says what is wrong.
  return unknown ? std::filesystem::exists(path, unknown) : size > 0;
}

bool is_json(const std::filesystem::path& path) {
  try {
    SQLite::Database(path.string(), SQLite::OPEN_READONLY).execAndGet("PRAGMA schema_version");
    return false;
  } catch (const SQLite::Exception& fault) {
    if (fault.getErrorCode() != SQLITE_NOTADB) return false;
  }
  std::ifstream in(path, std::ios::binary);
  char first = 0;
  return static_cast<bool>(in >> first) && first == '{';
}

Connection connect_to_read(const std::filesystem::path& path) {
  auto connection =
      std::make_unique<SQLite::Database>(path.string(), SQLite::OPEN_READONLY, busy_milliseconds);
  try {
    connection->execAndGet("SELECT count(*) FROM sqlite_schema");  // SQLite opens on the first use
  } catch (const SQLite::Exception& fault) {
    const int code = fault.getErrorCode();
    if ((code != SQLITE_CANTOPEN && code != SQLITE_READONLY) || has_log(path)) throw;
    // A folder that cannot be written has no place for the index of the log; nobody writes there, either.
    connection = std::make_unique<SQLite::Database>(uri_of(path) + "?immutable=1",
                                                    SQLite::OPEN_READONLY | SQLite::OPEN_URI);
  }
  harden(*connection);
  return connection;
}

Connection connect_to_write(const std::filesystem::path& path) {
  auto connection = std::make_unique<SQLite::Database>(
      path.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, busy_milliseconds);
  harden(*connection);
  return connection;
}

void begin_writing(SQLite::Database& database) {
  database.exec("PRAGMA page_size = " + std::to_string(page_size));  // of effect in a new file only
  database.exec("PRAGMA journal_mode = WAL");
  database.exec("PRAGMA synchronous = FULL");
}

void leave_one_file(SQLite::Database& database) {
  database.setBusyTimeout(0);
  database.tryExec("PRAGMA journal_mode = DELETE");
}

}  // namespace sailmap::store
