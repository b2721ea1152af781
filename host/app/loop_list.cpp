#include "loop_list.hpp"

#include <algorithm>
#include <cmath>

namespace sailmap::app {
namespace {

constexpr Reason reasons[] = {Reason::accepted,  Reason::below_threshold, Reason::too_few_regions,
                              Reason::ambiguous, Reason::excluded,        Reason::no_nodes,
                              Reason::no_regions};

bool is_chosen(const Update& update, const LoopChoice& choice) {
  const Detection& d = update.detection;
  if (choice.reason != "all" && name(d.reason) != choice.reason) return false;
  if (update.image < choice.first_image || update.image > choice.last_image) return false;
  if (choice.node >= 0 && d.best.node != choice.node) return false;
  if (d.best.node < 0) return std::isinf(choice.least) && std::isinf(choice.most);
  return d.best.similarity >= choice.least && d.best.similarity <= choice.most;
}

double similarity(const Update* update) {
  const Candidate& best = update->detection.best;
  return best.node < 0 ? -std::numeric_limits<double>::infinity() : best.similarity;
}

// How near the runner-up is to the best, of 1.
double doubt(const Update* update) {
  const Detection& d = update->detection;
  if (d.best.node < 0 || d.runner_up.node < 0 || d.best.similarity <= 0) return 0;
  return d.runner_up.similarity / d.best.similarity;
}

}  // namespace

std::vector<std::string> loop_reasons() {
  std::vector<std::string> names;
  for (const Reason reason : reasons) names.emplace_back(name(reason));
  names.emplace_back("all");
  return names;
}

std::vector<std::string> loop_orders() { return {"image", "similarity", "doubt"}; }

std::vector<const Update*> chosen_loops(const TopologicalMap& map, const LoopChoice& choice) {
  std::vector<const Update*> out;
  for (const Update& update : map.history()) {
    if (is_chosen(update, choice)) out.push_back(&update);
  }
  if (choice.sort == "similarity") std::ranges::stable_sort(out, std::greater<>(), similarity);
  if (choice.sort == "doubt") std::ranges::stable_sort(out, std::greater<>(), doubt);
  if (choice.limit > 0) out.resize(std::min(out.size(), static_cast<std::size_t>(choice.limit)));
  return out;
}

const std::string& name_of_node(const TopologicalMap& map, int node) {
  return map.nodes()[static_cast<std::size_t>(node)].views.front().name;
}

}  // namespace sailmap::app
