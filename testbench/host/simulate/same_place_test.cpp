// That images of one place look alike and images of different places do not, by measures that have nothing to
// do with the simulator or with sailmap: ORB features with OpenCV's matcher.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "sailmap/simulator.hpp"

namespace sailmap {
namespace {

cv::Mat orb(const cv::Mat& image) {
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  std::vector<cv::KeyPoint> points;
  cv::Mat descriptors;
  cv::ORB::create(400)->detectAndCompute(grey, cv::noArray(), points, descriptors);
  return descriptors;
}

// Mutual nearest neighbours less than 40 bits apart.
int common_features(const cv::Mat& a, const cv::Mat& b) {
  std::vector<cv::DMatch> matches;
  cv::BFMatcher(cv::NORM_HAMMING, true).match(a, b, matches);
  return static_cast<int>(
      std::count_if(matches.begin(), matches.end(), [](const cv::DMatch& m) { return m.distance < 40; }));
}

TEST(SamePlace, LooksMoreAlikeThanOtherPlaces) {
  int right = 0;
  int queries = 0;
  double same_sum = 0;
  double other_sum = 0;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    SimulationConfig config;
    config.seed = seed;
    config.images_per_lap = 120;
    const Simulator simulator(config);
    std::vector<cv::Mat> first;
    for (int i = 0; i < 120; i += 10) first.push_back(orb(simulator.render(i)));
    for (std::size_t place = 0; place < first.size(); ++place) {
      const cv::Mat query = orb(simulator.render(120 + 10 * static_cast<int>(place)));
      std::size_t best = 0;
      std::vector<int> common;
      for (const cv::Mat& candidate : first) common.push_back(common_features(query, candidate));
      for (std::size_t i = 0; i < common.size(); ++i) {
        if (common[i] > common[best]) best = i;
        (i == place ? same_sum : other_sum) += common[i];
      }
      right += best == place ? 1 : 0;
      ++queries;
    }
  }
  const double same = same_sum / queries;
  const double other = other_sum / (queries * 11);
  std::cout << right << " of " << queries << " places found; common features: same place " << same
            << ", others " << other << '\n';
  EXPECT_GE(right, queries * 9 / 10);
  EXPECT_GT(same, 2 * other);
}

// Light and passers-by alone, seen from the same pose: the picture keeps its structure.
TEST(SamePlace, ThumbnailsCorrelate) {
  SimulationConfig config;
  config.images_per_lap = 100;
  config.jitter = 0;
  const Simulator simulator(config);
  const auto thumbnail = [&](int index) {
    cv::Mat grey;
    cv::cvtColor(simulator.render(index), grey, cv::COLOR_BGR2GRAY);
    cv::resize(grey, grey, {32, 24}, 0, 0, cv::INTER_AREA);
    return grey;
  };
  const auto correlation = [](const cv::Mat& a, const cv::Mat& b) {
    cv::Mat result;
    cv::matchTemplate(a, b, result, cv::TM_CCOEFF_NORMED);
    return result.at<float>(0, 0);
  };
  for (int i = 0; i < 100; i += 20) {
    const cv::Mat query = thumbnail(100 + i);
    const float same = correlation(query, thumbnail(i));
    EXPECT_GT(same, 0.7F) << i;
    for (int j = 0; j < 100; j += 20)
      if (j != i) {
        EXPECT_GT(same, correlation(query, thumbnail(j))) << i << ' ' << j;
      }
  }
}

}  // namespace
}  // namespace sailmap
