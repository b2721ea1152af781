#include "table_config.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/file_reading.hpp"
#include "json_fields.hpp"
#include "sailmap/error.hpp"
#include "sailmap/image_source.hpp"

namespace sailmap::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Relative paths are meant from `folder`; empty ones stay empty.
fs::path resolved(const fs::path& folder, const std::string& path) {
  return path.empty() ? fs::path() : (folder / path).lexically_normal();
}

bool is_empty_folder(const fs::path& path) {
  std::error_code failed;
  if (!fs::is_directory(path, failed)) return false;
  const fs::directory_iterator files(path, failed);
  return !failed && std::ranges::none_of(files, [](const fs::directory_entry& file) {
    return is_image_path(file.path()) || file.is_directory();
  });
}

// Where the images are that a key names.
struct Place {
  const char* key;
  std::string path;
};

// What the user has not filled in yet, in words; empty: nothing.
std::string not_filled_in(const JsonFields& fields, const fs::path& folder, const DataSet& data) {
  if (fields.has("folder") && fields.text("folder").empty()) return "folder is not filled in";
  std::error_code failed;
  if (fields.has("folder") && fs::is_directory(folder, failed) && fs::is_empty(folder, failed)) {
    return folder.string() + " is empty";
  }
  const std::vector<Place> places =
      fields.has("reference") || fields.has("query")
          ? std::vector<Place>{{"reference", data.reference}, {"query", data.query}}
          : std::vector<Place>{{"source", data.source}};
  for (const Place& place : places) {
    if (place.path.empty()) return std::string(place.key) + " is not filled in";
    if (is_empty_folder(place.path)) return place.path + " holds no image";
  }
  return data.ground_truth.empty() ? "ground_truth is not filled in" : "";
}

Selection selection_from(const JsonFields& fields) {
  const std::string layout = fields.text("layout", "plain");
  if (layout != "plain" && layout != "oxford") fields.fail("layout must be plain or oxford");
  if ((layout == "oxford") != fields.has("side")) {
    fields.fail("layout oxford and side left or right go together");
  }
  const std::string side = fields.text("side", "left");
  if (side != "left" && side != "right") fields.fail("side must be left or right");
  return {layout == "oxford", side == "left" ? Side::left : Side::right};
}

void check(const JsonFields& fields, const TableDataSet& entry) {
  const bool traverses = fields.has("reference") || fields.has("query");
  if (traverses == fields.has("source") || fields.has("reference") != fields.has("query")) {
    fields.fail("needs either source or both reference and query");
  }
  if (traverses && fields.has("exclude_recent")) fields.fail("exclude_recent is for one sequence");
  if (traverses && entry.data.selection.oxford) fields.fail("layout oxford is for one sequence");
  if (!traverses && fields.has("reference_poses")) {
    fields.fail("reference_poses goes with reference and query");
  }
  if (!entry.vocabulary.empty() && !entry.train_on.empty()) {
    fields.fail("takes vocabulary or train_on, not both");
  }
  if (entry.train_on == entry.name) fields.fail("train_on must name another data set");
}

TableDataSet data_set_from(const json& object, const fs::path& path, const std::string& where) {
  const JsonFields fields(
      object, where,
      {"name", "folder", "source", "reference", "query", "ground_truth", "reference_poses", "radius",
       "layout", "side", "exclude_recent", "length_km", "vocabulary", "train_on"});
  TableDataSet out;
  out.name = fields.text("name");
  if (out.name.empty()) fields.fail("has no name");
  const fs::path folder = path.parent_path() / fields.text("folder");
  const auto file = [&](const char* key) { return resolved(folder, fields.text(key)).string(); };
  DataSet& data = out.data;
  data.source = file("source");
  data.reference = file("reference");
  data.query = file("query");
  data.ground_truth = file("ground_truth");
  data.reference_poses = file("reference_poses");
  data.selection = selection_from(fields);
  data.exclude_recent = fields.integer("exclude_recent", data.exclude_recent, 0, 1000000000);
  data.radius = fields.number("radius", 0);
  if (fields.has("radius") && !(data.radius > 0)) fields.fail("radius must be above 0");
  if (fields.has("length_km")) {
    out.length = fields.number("length_km", 0);
    if (!(*out.length > 0)) fields.fail("length_km must be above 0");
  }
  out.vocabulary = file("vocabulary");
  out.train_on = fields.text("train_on");
  check(fields, out);
  out.skipped = not_filled_in(fields, folder, data);
  return out;
}

TableMethod method_from(const json& value, const fs::path& path, const std::string& where,
                        const Recogniser& common) {
  const json object = value.is_string() ? json{{"method", value}} : value;
  const JsonFields fields(object, where,
                          {"name", "method", "threshold", "temporal", "vocabulary", "words", "features"});
  TableMethod out{fields.text("name", fields.text("method")), common, {}};
  Recogniser& recogniser = out.recogniser;
  recogniser.method = fields.text("method");
  const std::vector<std::string> names = recogniser_names();
  if (std::ranges::find(names, recogniser.method) == names.end()) {
    std::string known;
    for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
    fields.fail("no method '" + recogniser.method + "'; there are: " + known);
  }
  recogniser.config.detection.threshold = fields.number("threshold", 0);
  recogniser.config.temporal = fields.integer("temporal", 0, 0, 1000);
  settle(recogniser, fields.has("threshold"));
  for (const char* key : {"vocabulary", "words", "features"}) {
    if (fields.has(key) && !recogniser.on_words()) {
      fields.fail(std::string(key) + " is for the methods fabmap and bow");
    }
  }
  recogniser.vocabulary = resolved(path.parent_path(), fields.text("vocabulary"));
  out.training.words = fields.integer("words", out.training.words, 2, 1000000);
  out.training.features = fields.integer("features", out.training.features, 1, 1000000);
  return out;
}

// The entries of the list under `key`; `from(value, name of the value)` makes one.
template <class Entry, class From>
std::vector<Entry> entries_from(const json& document, const char* key, const std::string& path, From from) {
  if (!document.contains(key) || !document.at(key).is_array() || document.at(key).empty()) {
    throw Error(path + ": " + key + " must be a list of at least one entry");
  }
  const std::string what = std::string(key) == "methods" ? "method" : "data set";
  std::vector<Entry> out;
  for (const json& value : document.at(key)) {
    Entry entry = from(value, path + ": " + what + " " + std::to_string(out.size() + 1));
    if (std::ranges::find(out, entry.name, &Entry::name) != out.end()) {
      throw Error(path + ": " + what + " '" + entry.name + "' a second time");
    }
    out.push_back(std::move(entry));
  }
  return out;
}

void check_training(const std::vector<TableDataSet>& all, const std::string& path) {
  for (const TableDataSet& entry : all) {
    if (entry.train_on.empty()) continue;
    if (std::ranges::find(all, entry.train_on, &TableDataSet::name) == all.end()) {
      throw Error(path + ": data set '" + entry.name + "': train_on names no data set '" + entry.train_on +
                  "'");
    }
  }
}

json parse(const fs::path& path) {
  std::ifstream in = io::open_for_reading(path);
  try {
    return json::parse(in, nullptr, true, true);  // with comments
  } catch (const json::exception& fault) {
    throw Error(path.string() + ": not JSON: " + fault.what());
  }
}

}  // namespace

TableConfig read_table_config(const fs::path& path, const Recogniser& common) {
  const json document = parse(path);
  const JsonFields fields(document, path.string(), {"data_sets", "methods"});
  TableConfig out;
  out.data_sets = entries_from<TableDataSet>(
      document, "data_sets", path.string(),
      [&](const json& value, const std::string& where) { return data_set_from(value, path, where); });
  out.methods = entries_from<TableMethod>(
      document, "methods", path.string(),
      [&](const json& value, const std::string& where) { return method_from(value, path, where, common); });
  check_training(out.data_sets, path.string());
  return out;
}

}  // namespace sailmap::app
