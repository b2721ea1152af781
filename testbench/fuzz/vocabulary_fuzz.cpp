// FAB-MAP's vocabulary file: what can be read is a model of probabilities, and the same when written again.
#include <cmath>
#include <opencv2/core.hpp>

#include "foreign_file.hpp"
#include "sailmap/fabmap.hpp"

namespace {

using namespace sailmap;
using fuzz::demand;

void check_words(const fabmap::Words& words, int count) {
  int last = -1;
  for (const int word : words) {
    demand(word > last && word < count, "words rise and are words");
    last = word;
  }
}

void check_tree(const fabmap::ChowLiuTree& tree) {
  const auto proper = [](double p) { return p > 0 && p < 1; };
  for (const fabmap::TreeNode& node : tree) {
    demand(proper(node.marginal) && proper(node.given_parent) && proper(node.given_no_parent),
           "probabilities are above 0 and below 1");
    std::size_t steps = 0;
    for (int at = node.parent; at != -1; at = tree[static_cast<std::size_t>(at)].parent) {
      demand(at >= 0 && static_cast<std::size_t>(at) < tree.size(), "a parent is a word");
      demand(++steps < tree.size(), "parents lead to a root");
    }
  }
}

void check(const fabmap::Vocabulary& vocabulary) {
  const int words = vocabulary.centres.rows;
  demand(words >= 2 && vocabulary.centres.cols == 128 && vocabulary.centres.type() == CV_32F,
         "centres are words x 128 numbers");
  demand(cv::checkRange(vocabulary.centres), "centres are finite");
  demand(vocabulary.tree.size() == static_cast<std::size_t>(words), "the tree has one node a word");
  demand(!vocabulary.training.empty() && vocabulary.features >= 1, "images were learned from");
  check_tree(vocabulary.tree);
  for (const fabmap::Words& image : vocabulary.training) check_words(image, words);
}

bool same(const fabmap::Vocabulary& a, const fabmap::Vocabulary& b) {
  const auto same_node = [](const fabmap::TreeNode& m, const fabmap::TreeNode& n) {
    return m.parent == n.parent && m.marginal == n.marginal && m.given_parent == n.given_parent &&
           m.given_no_parent == n.given_no_parent;
  };
  return cv::norm(a.centres, b.centres, cv::NORM_INF) == 0 && std::ranges::equal(a.tree, b.tree, same_node) &&
         a.training == b.training && a.features == b.features;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static fuzz::ForeignFile file(".vocabulary");
  const std::filesystem::path& path = file.hold(data, size);
  const auto vocabulary = fuzz::read_foreign(path, [&] { return fabmap::read_vocabulary(path); });
  if (!vocabulary) return 0;
  check(*vocabulary);
  fabmap::write_vocabulary(path, *vocabulary);
  demand(same(fabmap::read_vocabulary(path), *vocabulary), "a vocabulary is the same when written and read");
  fabmap::Fabmap places(*vocabulary, {});
  const fabmap::Words& image = vocabulary->training.front();
  places.add(image);
  places.add({});
  for (const double odds : places.log_odds(image, places.size())) {
    demand(!std::isnan(odds), "log-odds are numbers");
  }
  return 0;
}
