// Visual words: clusters of SIFT descriptors.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <opencv2/core.hpp>
#include <opencv2/features2d.hpp>
#include <random>

#include "check.hpp"
#include "sailmap/fabmap.hpp"

namespace sailmap::fabmap {
namespace {

cv::Mat descriptors_of(const cv::Mat& image, int features) {
  std::vector<cv::KeyPoint> keypoints;
  cv::Mat descriptors;
  cv::SIFT::create(features)->detectAndCompute(image, cv::noArray(), keypoints, descriptors);
  return descriptors;
}

// Each descriptor is given to its nearest centre, by OpenCV's bag of words.
Histogram counted(const cv::Mat& descriptors, const cv::Mat& centres) {
  Histogram out;
  if (descriptors.empty()) return out;
  cv::BOWImgDescriptorExtractor extractor(cv::makePtr<cv::BFMatcher>(cv::NORM_L2));
  extractor.setVocabulary(centres);
  cv::Mat parts;
  extractor.compute(descriptors, parts);
  for (int word = 0; word < parts.cols; ++word) {
    if (parts.at<float>(word) == 0) continue;
    out.words.push_back(word);
    out.parts.push_back(parts.at<float>(word));
  }
  return out;
}

// At most `most` rows, chosen at random.
cv::Mat sample(const cv::Mat& rows, int most, unsigned seed) {
  if (rows.rows <= most) return rows;
  std::vector<int> order(static_cast<std::size_t>(rows.rows));
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 random(seed);
  for (std::size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[random() % (i + 1)]);
  cv::Mat out;
  for (int i = 0; i < most; ++i) out.push_back(rows.row(order[static_cast<std::size_t>(i)]));
  return out;
}

}  // namespace

Vocabulary train(std::size_t count, const std::function<cv::Mat(std::size_t)>& image,
                 const TrainingConfig& config) {
  if (config.words < 2) throw Error("fabmap: a vocabulary needs at least 2 words");
  std::vector<cv::Mat> each(count);
  tbb::parallel_for(std::size_t{0}, count,
                    [&](std::size_t i) { each[i] = descriptors_of(image(i), config.features); });
  cv::Mat all;
  for (const cv::Mat& descriptors : each) {
    if (!descriptors.empty()) all.push_back(descriptors);
  }
  if (all.rows < config.words) {
    throw Error("fabmap: " + std::to_string(all.rows) + " descriptors in " + std::to_string(count) +
                " images are too few for " + std::to_string(config.words) + " words");
  }
  Vocabulary out;
  out.features = config.features;
  cv::theRNG().state = config.seed;
  const cv::Mat chosen = sample(all, std::max(config.sample, config.words), config.seed);
  cv::Mat labels;
  cv::kmeans(chosen, config.words, labels,
             cv::TermCriteria(cv::TermCriteria::MAX_ITER + cv::TermCriteria::EPS, config.iterations, 1e-3), 1,
             cv::KMEANS_PP_CENTERS, out.centres);
  out.training.resize(count);
  tbb::parallel_for(std::size_t{0}, count,
                    [&](std::size_t i) { out.training[i] = counted(each[i], out.centres).words; });
  out.tree = learn_tree(out.training, config.words);
  return out;
}

Histogram histogram_of(const cv::Mat& image, const Vocabulary& vocabulary) {
  return counted(descriptors_of(image, vocabulary.features), vocabulary.centres);
}

}  // namespace sailmap::fabmap
