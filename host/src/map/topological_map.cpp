// Spec section 11: the map is built image by image.
#include "sailmap/topological_map.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "consistency.hpp"
#include "sailmap/context.hpp"
#include "sailmap/error.hpp"

namespace sailmap {
namespace {

// How alike an image is to a node: to the most similar of the node's views.
MatchResult best_match(const Signature& signature, const Node& node, const MatchConfig& config) {
  MatchResult best;
  for (const View& view : node.views) {
    MatchResult result = match(signature, view.signature, config);
    if (result.similarity > best.similarity) best = std::move(result);
  }
  return best;
}

// The same number for both directions of an edge.
std::uint64_t ends(int from, int to) {
  const auto low = static_cast<std::uint32_t>(std::min(from, to));
  const auto high = static_cast<std::uint32_t>(std::max(from, to));
  return (static_cast<std::uint64_t>(high) << 32U) | low;
}

std::vector<Candidate> filtered(std::vector<Candidate> candidates, TemporalFilter& filter) {
  std::vector<float> scores;
  scores.reserve(candidates.size());
  for (const Candidate& candidate : candidates) scores.push_back(static_cast<float>(candidate.similarity));
  const std::vector<float> mixed = filter.apply(scores);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    // An unfiltered similarity keeps its full precision.
    if (mixed[i] != scores[i]) candidates[i].similarity = static_cast<double>(mixed[i]);
  }
  return candidates;
}

}  // namespace

std::string_view name(EdgeKind kind) { return kind == EdgeKind::path ? "path" : "loop"; }

EdgeKind edge_kind_from_name(std::string_view name) {
  if (name == "path") return EdgeKind::path;
  if (name == "loop") return EdgeKind::loop;
  throw Error("no edge kind '" + std::string(name) + "'");
}

TopologicalMap::TopologicalMap(MapConfig config, std::vector<Node> nodes, std::vector<Edge> edges,
                               std::vector<Update> history, int active, std::vector<int> sessions)
    : config_(config),
      nodes_(std::move(nodes)),
      edges_(std::move(edges)),
      history_(std::move(history)),
      sessions_(sessions.empty() ? std::vector<int>{0} : std::move(sessions)),
      active_(active),
      filter_(temporal_config(config.match.method, config.temporal)) {
  check_consistency(nodes_, edges_, history_, active_, sessions_);
  for (const Node& node : nodes_) {
    for (std::size_t v = 0; v < node.views.size(); ++v) {
      if (uses_index()) index_.add({node.id, static_cast<int>(v)}, node.views[v].signature);
    }
  }
  for (const Edge& edge : edges_) {
    if (edge.kind == EdgeKind::loop) loop_edges_.insert(ends(edge.from, edge.to));
  }
}

void TopologicalMap::begin_session() {
  if (sessions_.back() == images()) return;
  sessions_.push_back(images());
  filter_ = TemporalFilter(temporal_config(config_.match.method, config_.temporal));
}

void TopologicalMap::demand_same_size(const std::string& name, const Signature& signature) const {
  if (nodes_.empty()) return;
  const Signature& first = nodes_.front().views.front().signature;
  if (signature.width == first.width && signature.height == first.height) return;
  throw Error(name + ": " + std::to_string(signature.width) + "x" + std::to_string(signature.height) +
              " pixels, but the map's images are " + std::to_string(first.width) + "x" +
              std::to_string(first.height));
}

// Among the first so many nodes.
Detection TopologicalMap::detect(const Signature& signature, int nodes) {
  Detection detection = decide_ranked(compare(signature, nodes), config_.detection, [&](int node) {
    return best_match(signature, nodes_[static_cast<std::size_t>(node)], config_.match).matches;
  });
  if (signature.regions.empty()) {
    detection.reason = Reason::no_regions;
  } else if (nodes == 0 && !nodes_.empty()) {
    detection.reason = Reason::excluded;
  } else if (nodes > 0 && detection.best.node < 0) {  // see DetectionConfig::ranked_nodes
    detection.reason = Reason::below_threshold;
  }
  return detection;
}

Detection TopologicalMap::locate(const std::string& name, const Signature& signature) {
  demand_same_size(name, signature);
  return detect(signature, static_cast<int>(nodes_.size()));
}

const Update& TopologicalMap::add(std::string name, Signature signature) {
  demand_same_size(name, signature);
  Update update;
  update.image = images();
  update.name = name;
  const bool follows = update.image != sessions_.back();  // the robot came here from the active node
  advance_admissible(update.image);
  update.detection = detect(signature, admissible_);

  View view{update.image, std::move(name), std::move(signature)};
  if (update.detection.accepted()) {
    update.node = update.detection.best.node;
    if (config_.loop_edges && follows && update.node != active_) add_loop(active_, update.node);
    if (config_.sparse) add_view(update.node, std::move(view));
  } else if (config_.sparse && follows && belongs_to_active(view.signature)) {
    update.node = active_;
    add_view(active_, std::move(view));
  } else {
    update.node = static_cast<int>(nodes_.size());
    update.new_node = true;
    add_node(std::move(view));
    // The first edge of a new node: no need to look whether it is known.
    if (follows && active_ >= 0) edges_.push_back({active_, update.node, EdgeKind::path});
  }
  active_ = update.node;
  history_.push_back(std::move(update));
  return history_.back();
}

int TopologicalMap::loops() const {
  return static_cast<int>(std::count_if(history_.begin(), history_.end(),
                                        [](const Update& update) { return update.detection.accepted(); }));
}

// Nodes are numbered by age, so that all that follow a recent one are newer still; and what is not recent
// never is again.
void TopologicalMap::advance_admissible(int image) {
  const auto is_recent = [&](const Node& node) {
    const int made = node.views.front().image;
    return made >= sessions_.back() && image - made <= config_.exclude_recent;
  };
  while (admissible_ < static_cast<int>(nodes_.size()) &&
         !is_recent(nodes_[static_cast<std::size_t>(admissible_)])) {
    ++admissible_;
  }
}

// It knows the paper's similarities, and the temporal filter needs all scores.
bool TopologicalMap::uses_index() const {
  return config_.match.method != Method::context && config_.temporal < 2;
}

Ranking TopologicalMap::compare(const Signature& signature, int nodes) {
  if (!uses_index()) {
    return rank(filtered(score_all(signature, nodes), filter_), config_.detection.same_place_nodes);
  }
  if (nodes == 0) return {};
  const DetectionConfig& detection = config_.detection;
  const double at_least = nodes > detection.ranked_nodes ? least_that_matters(detection) : 0;
  return index_.find(signature, {nodes, detection.same_place_nodes, at_least}, config_.match,
                     [this](const PlaceIndex::Entry& entry) -> const Signature& {
                       const Node& node = nodes_[static_cast<std::size_t>(entry.node)];
                       return node.views[static_cast<std::size_t>(entry.view)].signature;
                     });
}

std::vector<Candidate> TopologicalMap::score_all(const Signature& signature, int nodes) const {
  std::vector<Candidate> candidates;
  std::vector<const PlaceDescriptor*> places;
  std::vector<std::size_t> node_of;
  for (int id = 0; id < nodes; ++id) {
    const Node& node = nodes_[static_cast<std::size_t>(id)];
    candidates.push_back({id, 0});
    if (config_.match.method != Method::context) {
      candidates.back().similarity = best_match(signature, node, config_.match).similarity;
      continue;
    }
    for (const View& view : node.views) {
      places.push_back(&view.signature.place.get());
      node_of.push_back(candidates.size() - 1);
    }
  }
  const std::vector<float> scores = score_contexts(signature.place, places);
  for (std::size_t i = 0; i < scores.size(); ++i) {
    double& similarity = candidates[node_of[i]].similarity;
    similarity = std::max(similarity, static_cast<double>(scores[i]));
  }
  return candidates;
}

bool TopologicalMap::belongs_to_active(const Signature& signature) const {
  if (active_ < 0) return false;
  const Node& node = nodes_[static_cast<std::size_t>(active_)];
  return best_match(signature, node, config_.match).similarity > config_.sparse_threshold;
}

void TopologicalMap::add_node(View view) {
  Node node;
  node.id = static_cast<int>(nodes_.size());
  if (uses_index()) index_.add({node.id, 0}, view.signature);
  node.views.push_back(std::move(view));
  nodes_.push_back(std::move(node));
}

void TopologicalMap::add_view(int node, View view) {
  std::vector<View>& views = nodes_[static_cast<std::size_t>(node)].views;
  if (uses_index()) index_.add({node, static_cast<int>(views.size())}, view.signature);
  views.push_back(std::move(view));
}

void TopologicalMap::add_loop(int from, int to) {
  if (loop_edges_.insert(ends(from, to)).second) edges_.push_back({from, to, EdgeKind::loop});
}

}  // namespace sailmap
