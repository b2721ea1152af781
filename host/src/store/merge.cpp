#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "connection.hpp"
#include "map/config_json.hpp"
#include "replace_file.hpp"
#include "sailmap/map_maintenance.hpp"
#include "sailmap/map_store.hpp"
#include "write_rows.hpp"

namespace sailmap {

using namespace store;

namespace {

using nlohmann::ordered_json;

// JSON pointers of the values that differ, with both values.
void list_differences(const ordered_json& a, const ordered_json& b, const std::string& key,
                      std::string& out) {
  if (a.is_object()) {
    for (const auto& [name, value] : a.items()) {
      list_differences(value, b.at(name), key.empty() ? name : key + "." + name, out);
    }
  } else if (a != b) {
    out += (out.empty() ? "" : ", ") + key + " (" + a.dump() + " and " + b.dump() + ")";
  }
}

std::string differences(const Making& a, const Making& b) {
  ordered_json of_a = to_json(a.config);
  ordered_json of_b = to_json(b.config);
  of_a["frontend"] = a.frontend;
  of_b["frontend"] = b.frontend;
  std::string out;
  list_differences(of_a, of_b, "", out);
  return out;
}

// All of a file as it is, in a new one.
void copy_map(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (is_json(from)) {
    const StoredMap stored = MapStore(from).load();
    return MapStore(to).save(stored.map, stored.frontend);
  }
  with_file(from, [&] { connect_to_read(from)->backup(to.c_str(), SQLite::Database::BackupType::Save); });
}

class Merger {
 public:
  // `to` is a copy of the map that is added to.
  explicit Merger(const std::filesystem::path& to)
      : writer_(to),
        stored_(writer_.load().value()),
        nodes_of_a_(static_cast<int>(stored_.map.nodes().size())) {}

  void begin_session(const std::string& source) {
    writer_.commit();
    stored_.map.begin_session();
    writer_.begin_session(stored_, source);
  }
  void add(StoredImage image) {
    if (!image.signature) {
      ++merge_.left_out;
      return;
    }
    const Update& update = stored_.map.add(std::move(image.name), *image.signature);
    writer_.append(stored_.map, *image.signature, {image.time, std::move(image.thumbnail)});
    ++merge_.images;
    if (update.detection.accepted() && update.node < nodes_of_a_) ++merge_.loops_across;
    if (merge_.images % 1000 == 0) writer_.commit();
  }
  MapMerge finish() {
    writer_.finish();
    return merge_;
  }

 private:
  MapWriter writer_;
  StoredMap stored_;
  int nodes_of_a_;
  MapMerge merge_;
};

MapMerge append_map(const MapStore& b, const std::filesystem::path& to) {
  const std::vector<Session> sessions = b.sessions();
  Merger merger(to);
  std::size_t next = 0;
  b.for_each_image([&](StoredImage image) {
    if (next < sessions.size() && image.image == sessions[next].first_image) {
      merger.begin_session(sessions[next++].source);
    }
    merger.add(std::move(image));
  });
  return merger.finish();
}

}  // namespace

MapMerge merge_maps(const std::filesystem::path& a, const std::filesystem::path& b,
                    const std::filesystem::path& to) {
  if (is_there(to)) throw Error(to.string() + ": exists already");
  if (const std::string differ = differences(MapStore(a).made_with(), MapStore(b).made_with());
      !differ.empty()) {
    throw Error(a.string() + " and " + b.string() + ": made with different parameters: " + differ);
  }
  // Beside its place until it is whole.
  const std::filesystem::path part = to.string() + ".merge";
  remove_with_log(part);
  try {
    copy_map(a, part);
    const MapMerge merge = append_map(MapStore(b), part);
    std::error_code failed;
    std::filesystem::rename(part, to, failed);
    if (failed) throw Error(to.string() + ": cannot be written: " + failed.message());
    return merge;
  } catch (...) {
    remove_with_log(part);
    throw;
  }
}

}  // namespace sailmap
