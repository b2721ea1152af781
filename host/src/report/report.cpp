// The page's data put together, and written.
#include "sailmap/report.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <set>

#include "builder.hpp"
#include "evaluation_file.hpp"
#include "graph.hpp"
#include "map/config_json.hpp"
#include "matrix.hpp"
#include "page.hpp"
#include "sailmap/error.hpp"
#include "sailmap/file.hpp"
#include "sailmap/map_store.hpp"

namespace sailmap {
namespace report {
namespace {

using nlohmann::ordered_json;

class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

ordered_json timing(const std::string& what, double value, const char* unit) {
  return {{"what", what}, {"value", shortened(value)}, {"unit", unit}};
}

void add_look_times(ordered_json& timings, const LookTimes& times, bool described) {
  if (times.images == 0) return;
  const auto each = [&](double seconds) { return 1000 * seconds / times.images; };
  timings.push_back(timing("Read and decode an image", each(times.read), "ms"));
  if (!described) return;
  timings.push_back(timing("Feature maps and saliency of an image", each(times.maps), "ms"));
  timings.push_back(timing("Regions and descriptors of an image", each(times.regions), "ms"));
}

std::string now() { return fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr))); }

ordered_json head(const char* kind, const Subject& subject, const std::string& method) {
  return {{"format", "sailmap report"},
          {"version", 1},
          {"kind", kind},
          {"title", subject.title},
          {"made", now()},
          {"method", method},
          {"frontend", subject.frontend.empty() ? ordered_json(nullptr) : ordered_json(subject.frontend)},
          {"threshold", shortened(subject.threshold)}};
}

// What both kinds of report end with.
void add_shown(ordered_json& data, Shown shown, const ReportOptions& options, Problems& problems) {
  if (!shown.left_out.empty()) {
    problems.add(fmt::format("Pictures are limited to {:.1f} MB (--budget): {} not shown.",
                             static_cast<double>(options.budget) / 1e6, shown.left_out));
  }
  data["pairs"] = std::move(shown.pairs);
  data["pictures"] = std::move(shown.pictures);
  data["problems"] = problems.json();
}

void check(const TopologicalMap& map, const ReportOptions& options) {
  if (!options.positions.empty() && options.positions.size() != static_cast<std::size_t>(map.images())) {
    throw Error(
        fmt::format("positions of {} images, but the map has {}", options.positions.size(), map.images()));
  }
  if (map.images() == 0) throw Error("the map is empty: there is nothing to report");
}

void check_images(const ReportOptions& options, std::size_t count) {
  for (const int image : options.images) {
    if (image >= 0 && static_cast<std::size_t>(image) < count) continue;
    throw Error(fmt::format("there is no image {}, they go from 0 to {}", image, count - 1));
  }
}

std::vector<Pick> picks_of(const Subject& subject, const ReportOptions& options) {
  return pick_loops(subject, static_cast<std::size_t>(std::max(0, options.pairs)));
}

// Of the images that the page compares or pictures; all of a large map's would be many.
StoredSignatures stored_signatures(const TopologicalMap& map, const Subject& subject,
                                   const std::vector<Pick>& picks, const ReportOptions& options) {
  StoredSignatures stored(&map);
  if (options.store == nullptr) return stored;
  std::set<int> wanted(options.images.begin(), options.images.end());
  for (const int row : matrix_rows(map)) wanted.insert(row);
  for (const Pick& pick : picks) wanted.insert(subject.loops[pick.loop].image);
  options.store->for_each_image([&](StoredImage image) {
    if (image.signature && wanted.contains(image.image) && stored.of(image.image) == nullptr) {
      stored.add(image.image, std::move(*image.signature));
    }
  });
  return stored;
}

void add_runs(ordered_json& timings, const ReportOptions& options) {
  if (options.store == nullptr) return;
  for (const Session& session : options.store->sessions()) {
    if (session.seconds <= 0) continue;
    timings.push_back(timing("Run over " + session.source, session.images / session.seconds, "images/s"));
  }
}

ordered_json build(const TopologicalMap& map, const std::string& frontend, const ReportOptions& options) {
  check(map, options);
  check_images(options, map.history().size());
  const Stopwatch whole;
  Problems problems;
  Subject subject = subject_of(map, frontend, options);
  ordered_json data = head("map", subject, std::string(name(map.config().match.method)));
  const Signature& first = map.nodes().front().views.front().signature;
  data["image_size"] = {first.width, first.height};
  data["images"] = names_of(subject.names);
  ordered_json timings = ordered_json::array();
  add_runs(timings, options);

  const Stopwatch layout;
  ordered_json graph = graph_of(map);
  graph["layout"] = rounded_positions(lay_out(static_cast<int>(map.nodes().size()), map.edges()));
  graph["positions"] = options.positions.empty() ? ordered_json(nullptr)
                                                 : rounded_positions(node_positions(map, options.positions));
  data["graph"] = std::move(graph);
  const double layout_seconds = layout.seconds();

  data["evaluation"] = options.truth ? evaluation_of(judge(subject, *options.truth)) : ordered_json(nullptr);
  data["history"] = history_of(map);
  data["sessions"] = map.sessions();
  data["loops"] = loops_of(subject);

  const std::vector<Pick> picks = picks_of(subject, options);
  const StoredSignatures stored = stored_signatures(map, subject, picks, options);
  Looker looker(frontend, map.config().regions, options.image_root);
  const Stopwatch comparing;
  const Similarities similarities = compare_images(map, [&](int image) -> std::optional<Signature> {
    if (const Signature* signature = stored.of(image); signature != nullptr) return *signature;
    try {
      return looker.look(subject.names[static_cast<std::size_t>(image)]).signature;
    } catch (const Error& fault) {
      problems.add_image(image, fault.what());
      return std::nullopt;
    }
  });
  if (similarities.unknown > 0) {
    problems.add(
        fmt::format("{} of the {} rows of the similarity matrix are empty: their images could not be read.",
                    similarities.unknown, similarities.rows.size()));
  }
  data["matrix"] = matrix_of(similarities, options.truth.value_or(GroundTruth{}));
  const double comparing_seconds = comparing.seconds() - looker.times().total();
  const auto compared = std::ranges::count_if(similarities.scores.samples(), [](float s) { return s == s; });

  add_shown(data, show(subject, picks, options, stored, looker, problems), options, problems);
  add_look_times(timings, looker.times(), true);
  if (compared > 0) {
    timings.push_back(
        timing("Compare two images", 1e6 * comparing_seconds / static_cast<double>(compared), "µs"));
  }
  timings.push_back(timing("Lay the graph out", layout_seconds, "s"));
  timings.push_back(timing("Make this report", whole.seconds(), "s"));
  data["timings"] = std::move(timings);
  data["parameters"] = to_json(map.config());
  return data;
}

ordered_json build(const std::filesystem::path& path, const ReportOptions& options) {
  const Stopwatch whole;
  EvaluationFile file = read_evaluation_file(path);
  if (!options.title.empty()) file.subject.title = options.title;
  check_images(options, file.subject.names.size());
  Problems problems;
  for (const std::string& problem : file.problems) problems.add(problem);
  ordered_json data = head("evaluation", file.subject, file.method);
  data["images"] = names_of(file.subject.names);
  data["queries"] = file.queries;
  data["candidates"] = file.candidates;
  data["evaluation"] = std::move(file.evaluation);
  data["history"] = std::move(file.history);
  data["loops"] = loops_of(file.subject);
  data["matrix"] = std::move(file.matrix);
  Looker looker(file.subject.frontend, file.subject.config.regions, options.image_root);
  add_shown(data,
            show(file.subject, picks_of(file.subject, options), options, StoredSignatures(nullptr), looker,
                 problems),
            options, problems);
  ordered_json timings = ordered_json::array();
  timings.push_back(timing("Images described in the evaluation", file.images_per_second, "images/s"));
  add_look_times(timings, looker.times(), !file.subject.frontend.empty());
  timings.push_back(timing("Make this report", whole.seconds(), "s"));
  data["timings"] = std::move(timings);
  data["parameters"] = std::move(file.parameters);
  return data;
}

void write(const std::filesystem::path& path, const ordered_json& data) {
  const std::string html = page(data);
  write_file(path, [&html](std::ostream& out) { out << html; });
}

}  // namespace
}  // namespace report

void write_report(const std::filesystem::path& path, const TopologicalMap& map, const std::string& frontend,
                  const ReportOptions& options) {
  report::write(path, report::build(map, frontend, options));
}

void write_evaluation_report(const std::filesystem::path& path, const std::filesystem::path& evaluation,
                             const ReportOptions& options) {
  report::write(path, report::build(evaluation, options));
}

}  // namespace sailmap
