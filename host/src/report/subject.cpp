#include "subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "sailmap/error.hpp"

namespace sailmap::report {

double margin(const Loop& loop, double threshold) {
  const double scale = std::max({std::abs(loop.score), std::abs(threshold), 1e-9});
  double nearest = loop.score - threshold;
  if (loop.rival >= 0) nearest = std::min(nearest, loop.score - loop.rival_score);
  return nearest / scale;
}

double shortened(double value) {
  if (!std::isfinite(value)) return value;
  return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
}

namespace {

// Of a node, those that were there when `image` came.
std::vector<int> views_before(const Node& node, int image) {
  std::vector<int> out;
  for (const View& view : node.views) {
    if (view.image < image) out.push_back(view.image);
  }
  return out;
}

// Whether nodes show the place of an image: a node stands for its views. An image that closed a loop in a
// dense map is none, since it might have been wrong.
class Judgement {
 public:
  explicit Judgement(const TopologicalMap& map) : map_(map), node_of_view_(map.history().size(), -1) {
    for (const Node& node : map.nodes()) {
      for (const View& view : node.views) node_of_view_[static_cast<std::size_t>(view.image)] = node.id;
    }
  }

  [[nodiscard]] bool right(int image, int node, const std::vector<int>& matches) const {
    return std::ranges::any_of(views_before(map_.nodes()[static_cast<std::size_t>(node)], image),
                               [&](int view) { return std::ranges::binary_search(matches, view); });
  }

  // Some node that was old enough to be compared with shows the same place.
  [[nodiscard]] bool has_match(int image, const std::vector<int>& matches) const {
    return std::ranges::any_of(matches, [&](int other) {
      const int node = other < image ? node_of_view_[static_cast<std::size_t>(other)] : -1;
      if (node < 0) return false;
      const int first = map_.nodes()[static_cast<std::size_t>(node)].views.front().image;
      return first < first_not_admissible(map_, image);
    });
  }

 private:
  const TopologicalMap& map_;
  std::vector<int> node_of_view_;
};

}  // namespace

// What was seen in an older session is admissible however recent it is.
int first_not_admissible(const TopologicalMap& map, int image) {
  const auto& sessions = map.sessions();
  const auto later = std::ranges::upper_bound(sessions, image);
  const int session = later == sessions.begin() ? 0 : *(later - 1);
  return std::max(image - map.config().exclude_recent, session);
}

Subject subject_of(const TopologicalMap& map, const std::string& frontend, const ReportOptions& options) {
  Subject subject;
  subject.title = options.title;
  subject.frontend = frontend;
  subject.config = map.config();
  subject.threshold = map.config().detection.threshold;
  subject.map = &map;
  const auto node = [&](int id) -> const Node& { return map.nodes()[static_cast<std::size_t>(id)]; };
  for (const Update& update : map.history()) {
    subject.names.push_back(update.name);
    const Detection& detection = update.detection;
    if (!detection.accepted()) continue;
    Loop loop{.image = update.image,
              .views = views_before(node(detection.best.node), update.image),
              .score = detection.best.similarity,
              .matches = detection.matches,
              .right = std::nullopt};
    if (loop.views.empty()) throw Error(fmt::format("image {} closes a loop with a later one", loop.image));
    if (detection.runner_up.node >= 0) {
      loop.rival = node(detection.runner_up.node).views.front().image;
      loop.rival_score = detection.runner_up.similarity;
    }
    subject.loops.push_back(std::move(loop));
  }
  return subject;
}

StoredSignatures::StoredSignatures(const TopologicalMap* map) {
  if (map == nullptr) return;
  by_image_.assign(map->history().size(), nullptr);
  for (const Node& node : map->nodes()) {
    for (const View& view : node.views) by_image_[static_cast<std::size_t>(view.image)] = &view.signature;
  }
}

void StoredSignatures::add(int image, Signature signature) {
  others_.insert_or_assign(image, std::move(signature));
}

const Signature* StoredSignatures::of(int image) const {
  const auto i = static_cast<std::size_t>(image);
  if (i < by_image_.size() && by_image_[i] != nullptr) return by_image_[i];
  const auto other = others_.find(image);
  return other == others_.end() ? nullptr : &other->second;
}

Evaluation judge(Subject& subject, const GroundTruth& truth) {
  const auto& history = subject.map->history();
  if (truth.matches.size() != history.size()) {
    throw Error(fmt::format("ground truth is for {} images, but the map has {}", truth.matches.size(),
                            history.size()));
  }
  const Judgement judgement(*subject.map);
  // A matrix of two columns says all that counts: the node that was detected, and, scored below it, any other
  // node of the same place.
  const float lowest = std::numeric_limits<float>::lowest();
  Plane<float> scores(2, static_cast<int>(history.size()), not_admissible);
  GroundTruth reduced;
  for (const Update& update : history) {
    const std::vector<int>& matches = truth.matches[static_cast<std::size_t>(update.image)];
    const Candidate& best = update.detection.best;
    const bool right = best.node >= 0 && judgement.right(update.image, best.node, matches);
    const bool has_match = judgement.has_match(update.image, matches);
    // An image without regions is like none of the nodes, so that its best one is any.
    if (best.node >= 0 || has_match) scores(0, update.image) = static_cast<float>(best.similarity);
    if (has_match) scores(1, update.image) = lowest;
    reduced.matches.emplace_back();
    if (right) reduced.matches.back().push_back(0);
    if (has_match) reduced.matches.back().push_back(1);
  }
  for (Loop& loop : subject.loops) {
    const std::vector<int>& matches = reduced.matches[static_cast<std::size_t>(loop.image)];
    loop.right = !matches.empty() && matches.front() == 0;
  }
  return evaluate(scores, reduced, subject.threshold);
}

}  // namespace sailmap::report
