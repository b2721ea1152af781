#include "live_state.hpp"

#include <algorithm>
#include <ctime>
#include <map>
#include <utility>

#include "map/config_json.hpp"
#include "report/builder.hpp"
#include "report/graph.hpp"

namespace sailmap::app {
namespace {

using nlohmann::ordered_json;

// Of the time, at most this part goes into layouts ...
constexpr double layout_share = 0.05;
// ... and no layout is begun that would take longer than this (seconds): the run's end would wait for it.
constexpr double longest_layout = 2;
// What a layout costs below so many places says nothing of larger ones.
constexpr std::size_t few_places = 200;

// Processor time of this thread, in seconds: what others do on the machine is not a layout's cost.
double thread_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_since(std::chrono::steady_clock::time_point then) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

ordered_json empty_columns(std::initializer_list<const char*> keys) {
  ordered_json out;
  for (const char* key : keys) out[key] = ordered_json::array();
  return out;
}

}  // namespace

LiveState::LiveState(std::string title, const TopologicalMap& map, std::string frontend)
    : title_(std::move(title)),
      frontend_(std::move(frontend)),
      config_(map.config()),
      sessions_(map.sessions()),
      images_at_start_(map.history().size()) {
  update(map);
}

void LiveState::update(const TopologicalMap& map) {
  const std::scoped_lock hold(lock_);
  for (std::size_t id = node_images_.size(); id < map.nodes().size(); ++id) {
    node_images_.push_back(map.nodes()[id].views.front().image);
  }
  edges_.insert(edges_.end(), map.edges().begin() + static_cast<std::ptrdiff_t>(edges_.size()),
                map.edges().end());
  for (std::size_t i = images_.size(); i < map.history().size(); ++i) take(map.history()[i], map);
  last_ = Clock::now();
}

void LiveState::take(const Update& update, const TopologicalMap& map) {
  const Detection& d = update.detection;
  const auto first_image = [&](int node) { return node_images_[static_cast<std::size_t>(node)]; };
  images_.push_back({update.name, update.node, d.best.node < 0 ? -1 : first_image(d.best.node),
                     d.best.similarity, d.reason});
  if (!d.accepted()) return;
  report::Loop loop;
  loop.image = update.image;
  loop.views = {first_image(d.best.node)};
  loop.score = d.best.similarity;
  if (d.runner_up.node >= 0) {
    loop.rival = first_image(d.runner_up.node);
    loop.rival_score = d.runner_up.similarity;
  }
  // Of a sparse map they may be those of another view than the first.
  if (!map.config().sparse) loop.matches = d.matches;
  loops_.push_back(std::move(loop));
}

ordered_json LiveState::empty_page() const {
  return {{"format", "sailmap report"},
          {"version", 1},
          {"kind", "live"},
          {"title", title_},
          {"method", sailmap::name(config_.match.method)},
          {"frontend", frontend_},
          {"threshold", config_.detection.threshold},
          {"images", {{"count", 0}, {"prefix", ""}, {"names", ordered_json::array()}}},
          {"graph",
           {{"nodes", 0},
            {"images", ordered_json::array()},
            {"paths", ordered_json::array()},
            {"active", -1},
            {"layout", ordered_json::array()},
            {"positions", nullptr}}},
          {"history", empty_columns({"node", "best", "score"})},
          {"sessions", sessions_},
          {"loops",
           empty_columns({"image", "place", "score", "rival", "rival_score", "margin", "right", "regions"})},
          {"evaluation", nullptr},
          {"matrix", nullptr},
          {"pairs", ordered_json::array()},
          {"pictures", ordered_json::object()},
          {"parameters", to_json(config_)}};
}

ordered_json LiveState::news(std::size_t images, int layout) {
  renew_layout();
  const std::scoped_lock hold(lock_);
  images = std::min(images, images_.size());
  ordered_json names = ordered_json::array();
  ordered_json history = empty_columns({"node", "best", "score"});
  for (std::size_t i = images; i < images_.size(); ++i) {
    const Image& image = images_[i];
    names.push_back(image.name);
    history["node"].push_back(image.node);
    history["best"].push_back(image.best < 0 ? ordered_json() : ordered_json(image.best));
    history["score"].push_back(image.best < 0 ? ordered_json()
                                              : ordered_json(report::shortened(image.score)));
  }
  report::Subject fresh;
  fresh.threshold = config_.detection.threshold;
  const auto first = std::ranges::lower_bound(loops_, static_cast<int>(images), {}, &report::Loop::image);
  fresh.loops.assign(first, loops_.end());
  // Nodes and their ways come with the image that made them.
  const auto node = std::ranges::lower_bound(node_images_, static_cast<int>(images));
  const auto known_nodes = static_cast<int>(node - node_images_.begin());
  ordered_json paths = ordered_json::array();
  for (const Edge& edge : edges_) {
    if (edge.kind != EdgeKind::path || std::max(edge.from, edge.to) < known_nodes) continue;
    paths.push_back(edge.from);
    paths.push_back(edge.to);
  }
  const double seconds = std::chrono::duration<double>(last_ - start_).count();
  const auto added = static_cast<double>(images_.size() - images_at_start_);
  ordered_json out = {{"names", std::move(names)},
                      {"history", std::move(history)},
                      {"loops", report::loops_of(fresh)},
                      {"graph",
                       {{"images", std::vector<int>(node, node_images_.end())},
                        {"paths", std::move(paths)},
                        {"active", images_.empty() ? -1 : images_.back().node}}},
                      {"rate", seconds > 0 ? added / seconds : 0.0}};
  if (layout != layout_version_) {
    out["layout"] = report::rounded_positions(layout_);
    out["layout_version"] = layout_version_;
  }
  return out;
}

// At most now and then: it works on a copy, and whoever asks meanwhile gets the last one.
void LiveState::renew_layout() {
  const std::unique_lock turn(layout_lock_, std::try_to_lock);
  if (!turn.owns_lock()) return;
  std::vector<Edge> edges;
  std::size_t nodes = 0;
  {
    const std::scoped_lock hold(lock_);
    nodes = node_images_.size();
    edges = edges_;
  }
  if (nodes == layout_nodes_ || seconds_since(layout_done_) < layout_seconds_ / layout_share) return;
  const double more = static_cast<double>(std::max(nodes, few_places)) /
                      static_cast<double>(std::max(layout_nodes_, few_places));
  if (layout_seconds_ * more * more > longest_layout || nodes > 5000) return;
  const double begin = thread_seconds();
  std::vector<double> layout = report::lay_out(static_cast<int>(nodes), edges);
  layout_done_ = Clock::now();
  layout_seconds_ = thread_seconds() - begin;
  layout_nodes_ = nodes;
  const std::scoped_lock hold(lock_);
  layout_ = std::move(layout);
  ++layout_version_;
}

std::optional<std::string> LiveState::name(std::size_t image) const {
  const std::scoped_lock hold(lock_);
  if (image >= images_.size()) return std::nullopt;
  return images_[image].name;
}

std::optional<LiveState::LoopCopy> LiveState::loop(std::size_t number) const {
  const std::scoped_lock hold(lock_);
  if (number >= loops_.size()) return std::nullopt;
  LoopCopy out;
  const report::Loop& loop = loops_[number];
  out.subject.frontend = frontend_;
  out.subject.config = config_;
  out.subject.threshold = config_.detection.threshold;
  out.subject.loops = {loop};
  out.image_name = images_[static_cast<std::size_t>(loop.image)].name;
  out.place_name = images_[static_cast<std::size_t>(loop.views.front())].name;
  return out;
}

}  // namespace sailmap::app
