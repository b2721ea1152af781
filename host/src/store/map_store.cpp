#include "sailmap/map_store.hpp"

#include <system_error>
#include <utility>

#include "connection.hpp"
#include "json_map.hpp"
#include "read_map.hpp"
#include "replace_file.hpp"
#include "schema.hpp"
#include "signature_bytes.hpp"
#include "write_lock.hpp"
#include "write_rows.hpp"

namespace sailmap {

using namespace store;

namespace {

// SQLite would say of all of these that they cannot be opened.
bool is_version_1(const std::filesystem::path& path) {
  std::error_code unknown;
  const auto type = std::filesystem::status(path, unknown).type();
  if (type == std::filesystem::file_type::not_found) throw Error(path.string() + ": no such file");
  if (type == std::filesystem::file_type::directory) throw Error(path.string() + ": a folder, not a file");
  return is_json(path);
}

// Calls `use` with an open map file of our schema inside one transaction, so that all it reads is of one
// moment.
template <class Use>
auto reading(const std::filesystem::path& path, const Use& use) {
  return with_file(path, [&] {
    const Connection connection = connect_to_read(path);
    const SQLite::Transaction moment(*connection);
    check_schema(*connection);
    return use(*connection);
  });
}

void for_each_view(const TopologicalMap& map, const std::function<void(StoredImage)>& use) {
  std::vector<const Signature*> signature_of(map.history().size(), nullptr);
  for (const Node& node : map.nodes()) {
    for (const View& view : node.views) signature_of[static_cast<std::size_t>(view.image)] = &view.signature;
  }
  for (const Update& update : map.history()) {
    StoredImage image{update.image, update.name, {}, {}, {}};
    const Signature* signature = signature_of[static_cast<std::size_t>(update.image)];
    if (signature != nullptr) image.signature = *signature;
    use(std::move(image));
  }
}

}  // namespace

bool MapStore::exists() const { return is_there(path_); }

StoredMap MapStore::load() const {
  if (is_version_1(path_)) return read_json_map(path_);
  return reading(path_, [](SQLite::Database& database) { return read_map(database); });
}

Making MapStore::made_with() const {
  if (is_version_1(path_)) {
    const StoredMap stored = read_json_map(path_);
    return {stored.map.config(), stored.frontend};
  }
  return reading(path_, [](SQLite::Database& database) {
    const MapRow row = read_map_row(database);
    return Making{config_of(row), row.frontend};
  });
}

void MapStore::save(const TopologicalMap& map, const std::string& frontend) const {
  with_file(path_, [&] {
    const WriteLock lock(path_);
    replace_file(path_, [&](SQLite::Database& database) { write_map(database, map, frontend); });
  });
}

std::vector<unsigned char> MapStore::thumbnail(int image) const {
  if (is_version_1(path_)) return {};
  return reading(path_, [&](SQLite::Database& database) {
    auto row = RowFinder<ThumbnailRow>(database).find(image);
    return row ? std::move(row->jpeg) : Blob{};
  });
}

std::vector<Session> MapStore::sessions() const {
  std::vector<Session> sessions;
  if (is_version_1(path_)) {
    const TopologicalMap map = load().map;
    for (const int first : map.sessions()) sessions.push_back({"", 0, first, map.images() - first, 0, 0});
    return sessions;
  }
  reading(path_, [&](SQLite::Database& database) {
    for (SessionRow& row : read_sessions(database)) {
      sessions.push_back(
          {std::move(row.source), row.started, row.first_image, row.images, row.skipped, row.seconds});
    }
  });
  return sessions;
}

void MapStore::for_each_image(const std::function<void(StoredImage)>& use) const {
  if (is_version_1(path_)) return for_each_view(load().map, use);
  reading(path_, [&](SQLite::Database& database) {
    RowFinder<SignatureRow> signatures(database);
    RowFinder<ThumbnailRow> thumbnails(database);
    for_each_row<ImageRow>(database, [&](ImageRow row) {
      StoredImage image{row.id, std::move(row.name), row.time, {}, {}};
      if (const auto signature = signatures.find(row.id)) image.signature = signature_from_row(*signature);
      if (auto thumbnail = thumbnails.find(row.id)) image.thumbnail = std::move(thumbnail->jpeg);
      use(std::move(image));
    });
  });
}

}  // namespace sailmap
