#include "leaders.hpp"

#include <algorithm>
#include <cstdlib>

namespace sailmap::index {
namespace {

// Higher similarity, the earlier node on ties.
bool precedes(const Candidate& a, const Candidate& b) {
  return a.similarity > b.similarity || (a.similarity == b.similarity && a.node < b.node);
}

}  // namespace

Leaders::Leaders(int same_place_nodes, double at_least)
    : same_place_nodes_(same_place_nodes),
      ranks_all_(!(at_least > 0)),
      threshold_(ranks_all_ ? 0 : at_least) {}

bool Leaders::apart(const Candidate& a, const Candidate& b) const {
  return std::abs(static_cast<long long>(a.node) - b.node) > 2 * std::max(0LL, same_place_nodes_);
}

void Leaders::add(Candidate candidate) {
  // The negation also keeps out what is no number.
  if (!(candidate.similarity > 0) || candidate.similarity < threshold_) return;
  found_.push_back(candidate);
  if (first_.node < 0 || candidate.similarity > first_.similarity) {
    const Candidate before = first_;
    first_ = candidate;
    if (before.node >= 0 && apart(before, first_)) {
      second_ = before;
    } else if (second_.node >= 0 && !apart(second_, first_)) {
      second_ = {};
    }
  } else if (apart(candidate, first_) && candidate.similarity > second_.similarity) {
    second_ = candidate;
  }
  if (second_.node >= 0) threshold_ = std::max(threshold_, second_.similarity);
}

int Leaders::first_of_another_place(int best, int nodes) const {
  if (std::abs(static_cast<long long>(best)) > same_place_nodes_) return 0;
  const long long next = best + same_place_nodes_ + 1;
  return next < nodes ? static_cast<int>(next) : -1;
}

Ranking Leaders::ranking(int nodes) const {
  Ranking out;
  if (nodes <= 0) return out;
  if (ranks_all_) out.best = {0, 0};
  for (const Candidate& candidate : found_) {
    if (precedes(candidate, out.best)) out.best = candidate;
  }
  if (ranks_all_) out.runner_up = {first_of_another_place(out.best.node, nodes), 0};
  for (const Candidate& candidate : found_) {
    const long long away = std::abs(static_cast<long long>(candidate.node) - out.best.node);
    if (away > same_place_nodes_ && precedes(candidate, out.runner_up)) out.runner_up = candidate;
  }
  return out;
}

}  // namespace sailmap::index
