// The topological map: nodes are places, edges say how the robot went or came back (spec 11).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "sailmap/detection.hpp"
#include "sailmap/place_index.hpp"
#include "sailmap/signature.hpp"
#include "sailmap/similarity.hpp"
#include "sailmap/temporal_filter.hpp"

namespace sailmap {

enum class EdgeKind {
  path,  // the robot went from one place to the next
  loop   // a loop closure joined two places
};

std::string_view name(EdgeKind kind);
EdgeKind edge_kind_from_name(std::string_view name);  // throws Error

struct MapConfig {
  RegionConfig regions;
  MatchConfig match;
  DetectionConfig detection;
  // The nodes made by so many newest images are not compared: they are neighbours in time, not loops.
  int exclude_recent = 20;
  // Strict paper mode is false: a loop closure then only moves the active node.
  bool loop_edges = true;
  // Sparse map: an image similar to the active node joins it instead of making a node of its own, and one
  // that closes a loop joins the node it closes with. Dense (the paper): a node is one image.
  bool sparse = false;
  double sparse_threshold = 20;  // similarity above which an image belongs to the active node
  int temporal = 0;              // images that the temporal filter spans; 0: no filter
};

// One image that stands for a node.
struct View {
  int image = 0;     // number of the image in the map, from 0
  std::string name;  // path or name the source gave it
  Signature signature;
};

struct Node {
  int id = 0;
  std::vector<View> views;  // one in a dense map; the first made the node
};

struct Edge {
  int from = 0;
  int to = 0;
  EdgeKind kind = EdgeKind::path;
  bool operator==(const Edge&) const = default;
};

// What one image did to the map.
struct Update {
  int image = 0;
  std::string name;
  int node = 0;  // active node afterwards
  bool new_node = false;
  Detection detection;
};

class TopologicalMap {
 public:
  explicit TopologicalMap(MapConfig config = {})
      : config_(config), filter_(temporal_config(config.match.method, config.temporal)) {}
  // A map as it was stored; `sessions` holds the first image of each session, rising from 0, and is empty
  // when there is one. Throws Error when the parts contradict each other.
  TopologicalMap(MapConfig config, std::vector<Node> nodes, std::vector<Edge> edges,
                 std::vector<Update> history, int active, std::vector<int> sessions = {});

  // The images from now on were taken after the robot stopped and began anew, it may be elsewhere: no edge
  // leads to the first from the image before it, and all that was seen in older sessions may be met at once,
  // however recent.
  void begin_session();

  // Where an image is on the map, which stays as it is: compared with all nodes, recent ones too. The
  // temporal filter, if there is one, takes the images located one after the other for a sequence. Throws
  // Error when the image's size is not that of the map's images.
  Detection locate(const std::string& name, const Signature& signature);

  // Compares the image with all admissible nodes and updates the map. Throws Error when the image's size is
  // not that of the map's images; the map is then unchanged.
  const Update& add(std::string name, Signature signature);

  [[nodiscard]] const MapConfig& config() const { return config_; }
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  [[nodiscard]] const std::vector<Update>& history() const { return history_; }  // one per image
  [[nodiscard]] const std::vector<int>& sessions() const { return sessions_; }   // first image of each
  [[nodiscard]] int images() const { return static_cast<int>(history_.size()); }
  [[nodiscard]] int active() const { return active_; }  // -1 when empty
  [[nodiscard]] int loops() const;                      // accepted detections

 private:
  void demand_same_size(const std::string& name, const Signature& signature) const;
  void advance_admissible(int image);
  [[nodiscard]] Ranking compare(const Signature& signature, int nodes);
  [[nodiscard]] Detection detect(const Signature& signature, int nodes);
  [[nodiscard]] bool belongs_to_active(const Signature& signature) const;
  void add_node(View view);
  void add_view(int node, View view);
  void add_loop(int from, int to);
  [[nodiscard]] bool uses_index() const;
  [[nodiscard]] std::vector<Candidate> score_all(const Signature& signature, int nodes) const;

  MapConfig config_;
  std::vector<Node> nodes_;
  std::vector<Edge> edges_;
  std::vector<Update> history_;
  std::vector<int> sessions_ = {0};
  int active_ = -1;
  int admissible_ = 0;  // nodes 0 .. admissible_ - 1 are older than exclude_recent, or than the session
  PlaceIndex index_;    // all views
  std::unordered_set<std::uint64_t> loop_edges_;  // both ends in one number, see topological_map.cpp
  TemporalFilter filter_;                         // begins anew with a map that was stored
};

}  // namespace sailmap
