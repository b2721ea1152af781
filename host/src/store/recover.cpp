// What can be read of a damaged map file: row by row, since one damaged page hides only the rows on it.
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <map>
#include <system_error>
#include <vector>

#include "connection.hpp"
#include "parts.hpp"
#include "read_map.hpp"
#include "replace_file.hpp"
#include "row_io.hpp"
#include "sailmap/map_maintenance.hpp"
#include "schema.hpp"
#include "write_lock.hpp"

namespace sailmap {

using namespace store;

namespace {

// Copies of files that go away again.
class WorkingCopy {
 public:
  WorkingCopy(const std::filesystem::path& from, const std::filesystem::path& beside)
      : path_(beside.string() + ".damaged" + std::to_string(::getpid())) {
    copy(from, path_);
    std::error_code unknown;
    const std::filesystem::path log = from.string() + "-wal";
    if (std::filesystem::exists(log, unknown)) copy(log, path_.string() + "-wal");
  }
  WorkingCopy(const WorkingCopy&) = delete;
  WorkingCopy& operator=(const WorkingCopy&) = delete;
  WorkingCopy(WorkingCopy&&) = delete;
  WorkingCopy& operator=(WorkingCopy&&) = delete;
  ~WorkingCopy() { remove_with_log(path_); }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  static void copy(const std::filesystem::path& from, const std::filesystem::path& to) {
    std::error_code failed;
    std::filesystem::copy_file(from, to, std::filesystem::copy_options::overwrite_existing, failed);
    if (failed) throw Error("cannot be copied to " + to.string() + ": " + failed.message());
  }
  std::filesystem::path path_;
};

bool has_schema(const std::filesystem::path& path) {
  try {
    check_schema(*connect_to_write(path));
    return true;
  } catch (const SQLite::Exception&) {
    return false;
  } catch (const Error&) {
    return false;
  }
}

// The first page holds nothing of the map, only where the tables begin, which is the same in all map files:
// that of an empty one is as good.
void replace_first_page(const std::filesystem::path& damaged, const std::filesystem::path& empty) {
  replace_file(empty, [](SQLite::Database&) {});
  std::vector<char> page(page_size);
  std::ifstream(empty, std::ios::binary).read(page.data(), page_size);
  // Where tables begin must be in the file, and the file whole pages; what is missing reads as damaged pages.
  const auto least = std::filesystem::file_size(empty) / page_size;
  const auto pages = std::max(least, (std::filesystem::file_size(damaged) + page_size - 1) / page_size);
  remove_with_log(empty);
  std::filesystem::resize_file(damaged, pages * page_size);
  constexpr std::size_t size_at = 28;  // of the file in pages, highest byte first
  for (std::size_t i = 0; i < 4; ++i) page[size_at + i] = static_cast<char>(pages >> (24 - 8 * i));
  std::fstream(damaged, std::ios::binary | std::ios::in | std::ios::out).write(page.data(), page_size);
  std::error_code ignored;
  std::filesystem::remove(damaged.string() + "-wal", ignored);
}

// Rows of one table by their number.
template <class Row>
class Salvage {
 public:
  // `most`: no number is higher.
  Salvage(SQLite::Database& database, int most)
      : statement_(database, select_statement<Row>("WHERE id >= ? ORDER BY id")) {
    // A page holds no more than 2048 rows: after very many failures nothing follows that could be read.
    constexpr int most_failures = 1 << 17;
    int next = 0;
    for (int failures = 0; next <= most && failures < most_failures; ++next, ++failures) {
      const std::size_t before = rows_.size();
      if (read_on_from(next)) break;
      if (rows_.size() > before) failures = 0;
    }
  }
  [[nodiscard]] const std::map<int, Row>& rows() const { return rows_; }
  [[nodiscard]] int damaged() const { return damaged_; }

 private:
  // All rows from `next` on, up to one that cannot be read; true at the end of the table. `next` is then the
  // last that was tried.
  bool read_on_from(int& next) {
    try {
      statement_.tryReset();
      statement_.bind(1, next);
      while (statement_.executeStep()) {
        next = std::max(next, statement_.getColumn(0).getInt());
        keep();
        ++next;
      }
      return true;
    } catch (const SQLite::Exception&) {
      return false;
    }
  }
  void keep() {
    try {
      Row row = read_row<Row>(statement_);
      const int id = row.id;
      rows_.emplace(id, std::move(row));
    } catch (const Error&) {
      ++damaged_;
    }
  }

  SQLite::Statement statement_;
  std::map<int, Row> rows_;
  int damaged_ = 0;
};

template <class Row>
std::optional<Row> find(const std::map<int, Row>& rows, int id) {
  const auto found = rows.find(id);
  return found == rows.end() ? std::nullopt : std::optional<Row>(found->second);
}

// Numbers up to the last that are missing.
template <class Row>
int gaps(const std::map<int, Row>& rows) {
  return rows.empty() ? 0 : rows.rbegin()->first + 1 - static_cast<int>(rows.size());
}

struct Found {
  MapParts parts;
  int lost_rows = 0;
};

Found salvage(SQLite::Database& database, int most) {
  const Salvage<MapRow> map(database, 0);
  if (map.rows().empty()) throw Error("the parameters of the map are lost; nothing can be recovered without");
  const Salvage<SessionRow> sessions(database, most);
  const Salvage<ImageRow> images(database, most);
  const Salvage<DetectionRow> detections(database, most);
  const Salvage<SignatureRow> signatures(database, most);
  const Salvage<ThumbnailRow> thumbnails(database, most);
  const Salvage<EdgeRow> edges(database, most);
  Found found;
  found.parts.map = map.rows().at(0);
  for (const auto& [id, row] : sessions.rows()) found.parts.sessions.push_back(row);
  for (const auto& [id, row] : edges.rows()) found.parts.edges.push_back(row);
  for (const auto& [id, row] : images.rows()) {
    // Without its verdict an image is one that was compared with nothing.
    const DetectionRow none{id, std::string(name(Reason::no_nodes)), -1, 0, -1, 0, {}};
    found.parts.images.push_back({row, find(detections.rows(), id).value_or(none),
                                  find(signatures.rows(), id), find(thumbnails.rows(), id)});
  }
  found.lost_rows =
      gaps(sessions.rows()) + gaps(images.rows()) + gaps(detections.rows()) + gaps(edges.rows());
  found.lost_rows += signatures.damaged() + thumbnails.damaged();
  return found;
}

}  // namespace

MapRecovery recover_map(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (!is_there(from)) throw Error(from.string() + ": no such file, or an empty one");
  if (is_there(to)) throw Error(to.string() + ": exists already");
  const Found found = with_file(from, [&] {
    const WorkingCopy copy(from, to);
    if (!has_schema(copy.path())) replace_first_page(copy.path(), copy.path().string() + ".empty");
    const Connection connection = connect_to_write(copy.path());
    check_schema(*connection);
    // No row takes less than eight bytes.
    const auto most = static_cast<int>(std::min<std::uintmax_t>(std::filesystem::file_size(copy.path()) / 8,
                                                                std::numeric_limits<int>::max() - 1));
    return salvage(*connection, most);
  });
  return with_file(to, [&] {
    const MapParts parts = made_whole(found.parts);
    const WriteLock lock(to);
    MapRecovery recovery{static_cast<int>(parts.images.size()), 0, found.lost_rows};
    for (const ImageParts& image : parts.images)
      recovery.nodes = std::max(recovery.nodes, image.image.node + 1);
    replace_file(to, [&](SQLite::Database& database) { write_parts(database, parts); });
    return recovery;
  });
}

}  // namespace sailmap
