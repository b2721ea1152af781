#include "consistency.hpp"

#include <algorithm>
#include <functional>
#include <string>

#include "sailmap/error.hpp"

namespace sailmap {
namespace {

void demand(bool holds, const std::string& fault) {
  if (!holds) throw Error("map contradicts itself: " + fault);
}

// One node or image after the other, of a map of so many.
class Checker {
 public:
  Checker(const std::vector<Node>& nodes, const std::vector<Update>& history)
      : nodes_(nodes), count_(static_cast<int>(nodes.size())), images_(static_cast<int>(history.size())) {}

  [[nodiscard]] bool is_node(int id) const { return id >= 0 && id < count_; }

  void check(const Node& node, int number) const {
    const std::string name = "node " + std::to_string(number);
    demand(node.id == number, name + " is numbered " + std::to_string(node.id));
    demand(!node.views.empty(), name + " has no image");
    for (const View& view : node.views) {
      demand(view.image >= 0 && view.image < images_, name + " has an image that was never added");
      const Signature& first = nodes_.front().views.front().signature;
      demand(view.signature.width == first.width && view.signature.height == first.height,
             "images of different size");
    }
  }

  void check(const Edge& edge) const {
    demand(is_node(edge.from) && is_node(edge.to),
           "edge " + std::to_string(edge.from) + "-" + std::to_string(edge.to) + " leads to no node");
  }

  void check(const Update& update, int number) const {
    const std::string name = "image " + std::to_string(number);
    demand(update.image == number, name + " is numbered " + std::to_string(update.image));
    demand(is_node(update.node), name + " belongs to no node");
    for (const int candidate : {update.detection.best.node, update.detection.runner_up.node}) {
      demand(candidate == Candidate{}.node || is_node(candidate), name + " was compared with no node");
    }
    for (const RegionMatch& match : update.detection.matches) {
      demand(match.query >= 0 && match.candidate >= 0, name + " has a matched region that is none");
    }
  }

 private:
  const std::vector<Node>& nodes_;
  int count_;
  int images_;
};

}  // namespace

void check_consistency(const std::vector<Node>& nodes, const std::vector<Edge>& edges,
                       const std::vector<Update>& history, int active, const std::vector<int>& sessions) {
  const Checker checker(nodes, history);
  int number = 0;
  for (const Node& node : nodes) checker.check(node, number++);
  for (const Edge& edge : edges) checker.check(edge);
  number = 0;
  for (const Update& update : history) checker.check(update, number++);
  demand(active == (history.empty() ? -1 : history.back().node), "the active node is not the last image's");
  demand(sessions.front() == 0 && sessions.back() <= std::max(0, number) &&
             std::ranges::adjacent_find(sessions, std::greater_equal<>{}) == sessions.end(),
         "the sessions are not in order");
}

}  // namespace sailmap
