#include "run_report.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "json_output.hpp"
#include "map/config_json.hpp"

namespace sailmap::app {
namespace {

using nlohmann::ordered_json;

const std::string& name_of(const TopologicalMap& map, int node) {
  return map.nodes()[static_cast<std::size_t>(node)].views.front().name;
}

std::string line_of(const TopologicalMap& map, int image, const std::string& name, const Detection& d,
                    const char* words) {
  // Scores of the method context lie within 0 and 1.
  const int digits = map.config().match.method == Method::context ? 3 : 1;
  std::string line = fmt::format(
      "{}: image {} ({}) is at node {} ({}), similarity {:.{}f}, {} regions matched", words, image, name,
      d.best.node, name_of(map, d.best.node), d.best.similarity, digits, d.matches.size());
  if (d.runner_up.node >= 0) {
    line += fmt::format("; runner-up node {} with {:.{}f}", d.runner_up.node, d.runner_up.similarity, digits);
  }
  return line;
}

}  // namespace

void print_place(const TopologicalMap& map, int image, const std::string& name, const Detection& detection,
                 const char* event, const char* words, bool json) {
  if (json) {
    ordered_json out = {{"event", event}, {"image", image}, {"name", name}};
    if (detection.best.node >= 0) out["node_name"] = name_of(map, detection.best.node);
    out.update(to_json(detection));
    print_json(out);
  } else {
    fmt::print("{}\n", line_of(map, image, name, detection, words));
  }
  std::fflush(stdout);
}

void print_run_summary(const RunCounts& counts, const TopologicalMap& map, const std::string& path,
                       bool json) {
  const double rate = counts.seconds > 0 ? counts.images / counts.seconds : 0;
  if (json) {
    print_json({{"event", "summary"},
                {"images", counts.images},
                {"loops", counts.loops},
                {"skipped", counts.skipped},
                {"images_per_second", rate},
                {"map", path},
                {"map_images", map.images()},
                {"nodes", map.nodes().size()},
                {"edges", map.edges().size()},
                {"map_loops", map.loops()}});
    return;
  }
  fmt::print(
      "{}: {} images, {} nodes, {} edges, {} loops; this run {} images, {} loops, {:.1f} images per second\n",
      path, map.images(), map.nodes().size(), map.edges().size(), map.loops(), counts.images, counts.loops,
      rate);
}

}  // namespace sailmap::app
