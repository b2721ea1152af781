// FAB-MAP, the paper's own comparison: places told apart by the visual words they show, with the words'
// dependence learned as a Chow-Liu tree (Cummins and Newman, IJRR 2008; with the inverted index of
// FAB-MAP 2.0, IJRR 2011).
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "sailmap/ref/plane.hpp"

namespace sailmap::fabmap {

// The words that an image shows, rising and without repetition; word numbers from 0.
using Words = std::vector<int>;

// One word in the Chow-Liu tree. z = 1: the word is seen.
struct TreeNode {
  int parent = -1;             // word; -1: root
  double marginal = 0;         // p(z = 1)
  double given_parent = 0;     // p(z = 1 | parent seen); the marginal for the root
  double given_no_parent = 0;  // p(z = 1 | parent not seen)
};
using ChowLiuTree = std::vector<TreeNode>;  // one node a word

// The maximum spanning tree of the words' mutual information, its probabilities smoothed by half an image
// with and half an image without the word. Throws Error when there is no image or a word is out of range.
ChowLiuTree learn_tree(const std::vector<Words>& images, int words);

struct FabmapConfig {
  double detect_present = 0.39;  // p(z = 1 | e = 1): an element that is there is seen; 0 .. 1, exclusive
  double detect_absent = 0;      // p(z = 1 | e = 0); 0 .. detect_present
  double new_place_prior = 0.9;  // 0 .. 1, exclusive
};

// p(Z | place) for growing sets of places, each known by the words of one image.
class Places {
 public:
  // Throws Error when a probability is out of range.
  Places(ChowLiuTree tree, FabmapConfig config);

  // Throws Error when a word is out of range.
  void add(const Words& words);
  [[nodiscard]] std::size_t size() const { return base_.size(); }

  // log p(Z | place) of every place, Z all words of the image, seen or not. The cost is that of the inverted
  // index entries of the words seen and of their children in the tree.
  [[nodiscard]] std::vector<double> log_likelihoods(const Words& image) const;

 private:
  [[nodiscard]] double difference(int word, bool seen, bool parent_seen) const;
  [[nodiscard]] double absent(int word, bool seen, bool parent_seen) const;

  ChowLiuTree tree_;
  std::vector<std::vector<int>> children_;  // of each word
  // By word and (z, z of the parent): log p(z | z_parent, place without the word), and what is added when the
  // place has it.
  std::vector<double> absent_;
  std::vector<double> difference_;
  double nothing_seen_ = 0;                      // log p(no word seen | place without any)
  std::vector<std::vector<std::size_t>> index_;  // places that have the word
  std::vector<double> base_;                     // of each place: log p(no word seen | place)
};

struct TrainingConfig {
  int words = 1000;     // 2 ..
  int features = 500;   // SIFT keypoints an image, at most; 1 ..
  int sample = 40000;   // descriptors that k-means clusters, at most
  int iterations = 12;  // of k-means
  unsigned seed = 1;    // the same seed gives the same vocabulary
};

// Visual words of SIFT descriptors and everything learned with them.
struct Vocabulary {
  cv::Mat centres;                           // words x 128, float32
  ChowLiuTree tree;                          // one node a word
  std::vector<Words> training;               // of each training image: a sample of what places look like
  int features = TrainingConfig{}.features;  // SIFT keypoints an image, at most: as in training
};

// k-means over the SIFT descriptors of images 0 .. count-1 (8-bit BGR), then the Chow-Liu tree. `image` is
// called once for each, on several threads at once; the result does not depend on their number. Throws Error
// when the images have fewer descriptors than there shall be words, and what `image` throws.
Vocabulary train(std::size_t count, const std::function<cv::Mat(std::size_t)>& image,
                 const TrainingConfig& config);

// How often an image shows each word.
struct Histogram {
  Words words;
  std::vector<double> parts;  // of each of `words`: the part of the image's features that show it
};

// The words of an image: each SIFT descriptor's nearest centre. Empty when the image has no feature.
Histogram histogram_of(const cv::Mat& image, const Vocabulary& vocabulary);

// A JSON file, written whole or not at all; reading throws Error naming the file and what is wrong with it.
void write_vocabulary(const std::filesystem::path& path, const Vocabulary& vocabulary);
Vocabulary read_vocabulary(const std::filesystem::path& path);

// Recognition: p(L_i | Z) of known places and of a new one, whose likelihood is the mean over the training
// images taken as places. No motion model: every known place is as likely beforehand.
class Fabmap {
 public:
  Fabmap(const Vocabulary& vocabulary, const FabmapConfig& config);
  void add(const Words& words) { places_.add(words); }
  [[nodiscard]] std::size_t size() const { return places_.size(); }

  // Of the first `count` places, at most size(): log(p / (1 - p)), p = p(L_i | Z). Probabilities near 1
  // differ by less than a double can tell; their log-odds do not.
  [[nodiscard]] std::vector<double> log_odds(const Words& image, std::size_t count) const;

 private:
  FabmapConfig config_;
  Places places_;
  Places samples_;
};

// Log-odds of each image against all earlier ones but the `exclude_recent` newest: row = query, column =
// candidate, NaN where not admissible. Runs on all cores; the result does not depend on their number.
Plane<float> score_sequence(const std::vector<Words>& images, int exclude_recent,
                            const Vocabulary& vocabulary, const FabmapConfig& config = {});

// Two traverses: each query against all references.
Plane<float> score_traverses(const std::vector<Words>& queries, const std::vector<Words>& references,
                             const Vocabulary& vocabulary, const FabmapConfig& config = {});

// The temporal filter (sailmap/temporal_filter.hpp) over what the log-odds stand for, tempered
// (docs/recognition.md); log-odds again.
Plane<float> filter_log_odds(const Plane<float>& log_odds, int images);

// Log-odds above which an image is taken for a known place: p = 0.99.
inline constexpr double default_threshold = 4.6;

}  // namespace sailmap::fabmap
