// What is known of best node and runner-up while the nodes are compared, in whatever order.
#pragma once

#include <vector>

#include "sailmap/detection.hpp"

namespace sailmap::index {

class Leaders {
 public:
  // What is less similar than `at_least`, where that is above 0, counts as none.
  Leaders(int same_place_nodes, double at_least);

  void add(Candidate candidate);

  // Nodes less similar than this can be neither best nor runner-up. Of two nodes too far apart to be the same
  // place as any third, one at least is another place than the best, wherever that turns out to be: the
  // lesser of their similarities is a lower bound of the runner-up's.
  [[nodiscard]] double threshold() const { return threshold_; }

  // Once every node that reaches the threshold was added: the ranking among nodes 0 .. `nodes` - 1, those
  // never added having similarity 0 (and so being none, where that is less than was asked for).
  [[nodiscard]] Ranking ranking(int nodes) const;

 private:
  [[nodiscard]] bool apart(const Candidate& a, const Candidate& b) const;
  [[nodiscard]] int first_of_another_place(int best, int nodes) const;

  long long same_place_nodes_;
  bool ranks_all_;
  std::vector<Candidate> found_;  // similarity above 0
  Candidate first_;               // the most similar so far
  Candidate second_;              // the most similar apart from it; node -1 when unknown
  double threshold_;
};

}  // namespace sailmap::index
