// A map for graphviz, networkx, pose-graph tools, spreadsheets and scripts.
#include "sailmap/map_export.hpp"

#include <string>

#include "formats.hpp"
#include "map/map_json.hpp"
#include "sailmap/error.hpp"

namespace sailmap {
namespace {

struct Entry {
  std::string_view format;
  void (*write)(const TopologicalMap&, std::ostream&, const ExportOptions&);
};
constexpr Entry entries[] = {{"dot", write_dot},  {"graphml", write_graphml}, {"g2o", write_g2o},
                             {"tum", write_tum},  {"kitti", write_kitti},     {"csv", write_csv},
                             {"json", write_json}};

}  // namespace

void write_json(const TopologicalMap& map, std::ostream& out, const ExportOptions&) {
  out << to_json(map).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

std::vector<std::string_view> export_formats() {
  std::vector<std::string_view> formats;
  for (const Entry& entry : entries) formats.push_back(entry.format);
  return formats;
}

void export_map(const TopologicalMap& map, std::string_view format, std::ostream& out,
                const ExportOptions& options) {
  if (!options.poses.empty() && options.poses.size() != static_cast<std::size_t>(map.images())) {
    throw Error(std::to_string(options.poses.size()) + " poses for " + std::to_string(map.images()) +
                " images of the map");
  }
  std::string known;
  for (const Entry& entry : entries) {
    if (entry.format == format) return entry.write(map, out, options);
    known += (known.empty() ? "" : ", ") + std::string(entry.format);
  }
  throw Error("no export format '" + std::string(format) + "'; there are: " + known);
}

}  // namespace sailmap
