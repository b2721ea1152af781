// p(Z | place) with an inverted index: FAB-MAP 2.0's way, exact.
//
// log p(Z | L) is a sum over all words of log p(z_q | z_parent, L), and a term depends on the place only by
// whether L has the word. So it is that of a place without any word, plus a difference for each word that L
// has; and since most words are neither seen nor have a seen parent, their part is kept for each place and
// only the rest is corrected.
#include <cmath>
#include <utility>

#include "check.hpp"
#include "sailmap/fabmap.hpp"

namespace sailmap::fabmap {
namespace {

double either(bool value, double when_true) { return value ? when_true : 1 - when_true; }

// p(z_q | e_q, z_parent) from the tree and the detector (IJRR 2008, eq. 9 to 11): the two are taken as
// independent evidence of z_q, each against its marginal.
double seen_given_element(const TreeNode& node, double detect, bool seen, bool parent_seen) {
  const double tree = parent_seen ? node.given_parent : node.given_no_parent;
  const double against = either(seen, node.marginal) * either(!seen, detect) * either(!seen, tree);
  const double in_favour = either(!seen, node.marginal) * either(seen, detect) * either(seen, tree);
  return in_favour / (against + in_favour);
}

// p(e_q = 1 | L) of a place known by one image that shows the word or not; the prior is the marginal.
double element_given_place(const TreeNode& node, const FabmapConfig& config, bool has_word) {
  const double present = either(has_word, config.detect_present) * node.marginal;
  const double absent = either(has_word, config.detect_absent) * (1 - node.marginal);
  return present / (present + absent);
}

// log p(z_q | z_parent, L).
double log_term(const TreeNode& node, const FabmapConfig& config, bool seen, bool parent_seen,
                bool has_word) {
  const double element = element_given_place(node, config, has_word);
  const double p = element * seen_given_element(node, config.detect_present, seen, parent_seen) +
                   (1 - element) * seen_given_element(node, config.detect_absent, seen, parent_seen);
  return std::log(p);
}

std::size_t slot(int word, bool seen, bool parent_seen) {
  return 4 * static_cast<std::size_t>(word) + (seen ? 2 : 0) + (parent_seen ? 1 : 0);
}

void check(const FabmapConfig& config) {
  const bool right = config.detect_present > 0 && config.detect_present < 1 && config.detect_absent >= 0 &&
                     config.detect_absent < config.detect_present && config.new_place_prior > 0 &&
                     config.new_place_prior < 1;
  if (!right) throw Error("fabmap: a probability of the configuration is out of range");
}

// Do the parents of every word lead to a root?
bool is_forest(const ChowLiuTree& tree) {
  std::vector<bool> rooted(tree.size(), false);
  std::vector<std::size_t> path;
  for (std::size_t word = 0; word < tree.size(); ++word) {
    path.clear();
    for (std::size_t at = word; !rooted[at]; at = static_cast<std::size_t>(tree[at].parent)) {
      path.push_back(at);
      if (path.size() > tree.size()) return false;
      if (tree[at].parent < 0) break;
    }
    for (const std::size_t at : path) rooted[at] = true;
  }
  return true;
}

void check(const ChowLiuTree& tree) {
  const auto proper = [](double p) { return p > 0 && p < 1; };
  for (const TreeNode& node : tree) {
    if (!proper(node.marginal) || !proper(node.given_parent) || !proper(node.given_no_parent) ||
        node.parent < -1 || node.parent >= static_cast<int>(tree.size())) {
      throw Error("fabmap: a probability or parent of the tree is out of range");
    }
  }
  if (!is_forest(tree)) throw Error("fabmap: the parents of a word lead in a circle");
}

}  // namespace

Places::Places(ChowLiuTree tree, FabmapConfig config)
    : tree_(std::move(tree)),
      children_(tree_.size()),
      absent_(4 * tree_.size()),
      difference_(4 * tree_.size()),
      index_(tree_.size()) {
  check(config);
  check(tree_);
  for (int word = 0; word < static_cast<int>(tree_.size()); ++word) {
    const TreeNode& node = tree_[static_cast<std::size_t>(word)];
    if (node.parent >= 0) children_[static_cast<std::size_t>(node.parent)].push_back(word);
    for (const bool seen : {false, true}) {
      for (const bool parent_seen : {false, true}) {
        const std::size_t at = slot(word, seen, parent_seen);
        absent_[at] = log_term(node, config, seen, parent_seen, false);
        difference_[at] = log_term(node, config, seen, parent_seen, true) - absent_[at];
      }
    }
    nothing_seen_ += absent(word, false, false);
  }
}

double Places::absent(int word, bool seen, bool parent_seen) const {
  return absent_[slot(word, seen, parent_seen)];
}
double Places::difference(int word, bool seen, bool parent_seen) const {
  return difference_[slot(word, seen, parent_seen)];
}

void Places::add(const Words& words) {
  check_words(words, tree_.size());
  double base = 0;
  for (const int word : words) {
    index_[static_cast<std::size_t>(word)].push_back(base_.size());
    base += difference(word, false, false);
  }
  base_.push_back(base);
}

std::vector<double> Places::log_likelihoods(const Words& image) const {
  check_words(image, tree_.size());
  std::vector<bool> seen(tree_.size(), false);
  for (const int word : image) seen[static_cast<std::size_t>(word)] = true;
  std::vector<double> out = base_;
  double common = nothing_seen_;
  const auto correct = [&](int word) {
    const auto w = static_cast<std::size_t>(word);
    const int parent = tree_[w].parent;
    const bool parent_seen = parent >= 0 && seen[static_cast<std::size_t>(parent)];
    common += absent(word, seen[w], parent_seen) - absent(word, false, false);
    const double change = difference(word, seen[w], parent_seen) - difference(word, false, false);
    for (const std::size_t place : index_[w]) out[place] += change;
  };
  for (const int word : image) {
    correct(word);
    for (const int child : children_[static_cast<std::size_t>(word)]) {
      if (!seen[static_cast<std::size_t>(child)]) correct(child);
    }
  }
  for (double& value : out) value += common;
  return out;
}

}  // namespace sailmap::fabmap
