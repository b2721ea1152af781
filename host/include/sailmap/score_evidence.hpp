// What the scores of one image say about where it is: odds for each candidate, and how much likelier they are
// there than elsewhere.
#pragma once

#include <span>
#include <vector>

namespace sailmap {

// Fed the scores of one image after the other; remembers what each candidate usually gets.
class ScoreEvidence {
 public:
  // Of one image; 0 where a candidate is not admissible.
  struct Row {
    std::vector<float> odds;      // the scores as odds for the same place
    std::vector<float> standing;  // how far they stand out from what many candidates reach
    std::vector<bool> admissible;
    int count = 0;  // of admissible ones
  };

  // `scale`: the score that means even odds; infinity: scores are within 0 and 1 and mean s / (1 - s).
  explicit ScoreEvidence(double scale) : scale_(scale) {}

  // NaN where not admissible.
  [[nodiscard]] Row read(std::span<const float> scores) const;

  // Of these scores if the image is at a candidate, relative to anywhere: mean 1. Where some candidate is
  // admissible. Learns from the row.
  std::vector<float> likelihoods(const Row& row);

  [[nodiscard]] float score(float odds) const;

 private:
  double scale_;
  std::vector<float> sums_;  // of each candidate's likelihoods, and how many they are
  std::vector<float> counts_;
};

}  // namespace sailmap
