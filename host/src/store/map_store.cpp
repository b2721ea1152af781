#include "sailmap/map_store.hpp"

#include <utility>

#include "connection.hpp"
#include "io/file_reading.hpp"
#include "json_map.hpp"
#include "read_map.hpp"
#include "replace_file.hpp"
#include "schema.hpp"
#include "signature_bytes.hpp"
#include "write_rows.hpp"

namespace sailmap {

using namespace store;

namespace {

bool is_version_1(const std::filesystem::path& path) {
  static_cast<void>(
      io::open_for_reading(path));  // says what is wrong with a path that SQLite only cannot open
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
    StoredImage image{update.image, update.name, {}, {}};
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

void MapStore::save(const TopologicalMap& map, const std::string& frontend) const {
  with_file(path_, [&] {
    const WriteLock lock(path_);
    replace_file(path_, [&](SQLite::Database& database) { write_map(database, map, frontend); });
  });
}

std::vector<unsigned char> MapStore::thumbnail(int image) const {
  if (is_version_1(path_)) return {};
  return reading(path_, [&](SQLite::Database& database) {
    SQLite::Statement statement(database, select_statement<ThumbnailRow>("WHERE id = ?"));
    statement.bind(1, image);
    return statement.executeStep() ? read_row<ThumbnailRow>(statement).jpeg : Blob{};
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
    SQLite::Statement signature(database, select_statement<SignatureRow>("WHERE id = ?"));
    for_each_row<ImageRow>(database, [&](ImageRow row) {
      signature.reset();
      signature.bind(1, row.id);
      StoredImage image{row.id, std::move(row.name), row.time, {}};
      if (signature.executeStep()) image.signature = signature_from_row(read_row<SignatureRow>(signature));
      use(std::move(image));
    });
  });
}

}  // namespace sailmap
