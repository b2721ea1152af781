// The bag of words against numbers worked by hand, and its words against a search written here.
#include "sailmap/bag_of_words.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>
#include <random>

#include "sailmap/error.hpp"

namespace sailmap::bow {
namespace {

using fabmap::Histogram;
using fabmap::Vocabulary;

// Word 0 is in all three training images, word 1 in one, word 2 in none.
Vocabulary three_words() {
  Vocabulary out;
  out.tree.resize(3);
  out.training = {{0}, {0, 1}, {0}};
  return out;
}

TEST(Rarity, ByHand) {
  const std::vector<double> got = rarity(three_words());
  ASSERT_EQ(got.size(), 3U);
  EXPECT_DOUBLE_EQ(got[0], 0);
  EXPECT_DOUBLE_EQ(got[1], std::log(2.0));
  EXPECT_DOUBLE_EQ(got[2], std::log(4.0));
}

// Weighted by 1 and 2: (0.6, 0.4) becomes (0.6, 0.8), already of length 1; (1, 0) stays.
TEST(Similarity, ByHand) {
  const std::vector<double> weights = {0, 1, 2};
  const Histogram both{{1, 2}, {0.6, 0.4}};
  const Histogram first{{1}, {1}};
  EXPECT_NEAR(similarity(both, first, weights), 0.6, 1e-12);
  EXPECT_NEAR(similarity(both, both, weights), 1, 1e-12);
  EXPECT_EQ(similarity(first, {{2}, {1}}, weights), 0);
  // What every image shows says nothing, nor does an image without features.
  EXPECT_NEAR(similarity({{0, 1}, {0.9, 0.1}}, first, weights), 1, 1e-12);
  EXPECT_EQ(similarity({{0}, {1}}, {{0}, {1}}, weights), 0);
  EXPECT_EQ(similarity({}, first, weights), 0);
  EXPECT_THROW((void)similarity({{3}, {1}}, first, weights), Error);
}

TEST(BagScores, AreTheSimilarities) {
  const Vocabulary vocabulary = three_words();
  const std::vector<Histogram> images = {{{1}, {1}}, {{1, 2}, {0.5, 0.5}}, {{2}, {1}}, {{0, 1}, {0.5, 0.5}}};
  const Plane<float> scores = score_sequence(images, 1, vocabulary);
  for (int q = 0; q < 4; ++q) {
    for (int c = 0; c < 4; ++c) {
      if (c < q - 1) {
        const double expected = similarity(images[static_cast<std::size_t>(q)],
                                           images[static_cast<std::size_t>(c)], rarity(vocabulary));
        EXPECT_FLOAT_EQ(scores(c, q), static_cast<float>(expected));
      } else {
        EXPECT_TRUE(std::isnan(scores(c, q)));
      }
    }
  }
  EXPECT_THROW(score_sequence(images, -1, vocabulary), Error);
  const Plane<float> traverses = score_traverses(images, {images[2]}, vocabulary);
  EXPECT_FLOAT_EQ(traverses(0, 2), 1);
  EXPECT_FLOAT_EQ(traverses(0, 0), 0);
  // Weighted 1 and 2: the second word's part of the unit vector is 2 / sqrt(5).
  EXPECT_FLOAT_EQ(traverses(0, 1), static_cast<float>(2 / std::sqrt(5.0)));
}

TEST(Histograms, CountTheNearestCentres) {
  cv::Mat image(160, 200, CV_8UC3, cv::Scalar(90, 90, 90));
  std::mt19937 random(5);
  for (int i = 0; i < 40; ++i) {
    const cv::Point at(static_cast<int>(random() % 180), static_cast<int>(random() % 140));
    cv::rectangle(image, at, at + cv::Point(9, 7), cv::Scalar::all(static_cast<double>(random() % 256)), -1);
  }
  std::vector<cv::KeyPoint> keypoints;
  cv::Mat descriptors;
  cv::SIFT::create(500)->detectAndCompute(image, cv::noArray(), keypoints, descriptors);
  ASSERT_GT(descriptors.rows, 20);
  Vocabulary vocabulary;
  for (int i = 0; i < 10; ++i) vocabulary.centres.push_back(descriptors.row(2 * i));
  std::map<int, double> expected;
  for (int i = 0; i < descriptors.rows; ++i) {
    int nearest = 0;
    for (int k = 1; k < 10; ++k) {
      const auto distance = [&](int centre) {
        return cv::norm(descriptors.row(i), vocabulary.centres.row(centre));
      };
      if (distance(k) < distance(nearest)) nearest = k;
    }
    expected[nearest] += 1.0 / descriptors.rows;
  }
  const Histogram got = fabmap::histogram_of(image, vocabulary);
  ASSERT_EQ(got.words.size(), expected.size());
  for (std::size_t i = 0; i < got.words.size(); ++i) {
    EXPECT_NEAR(got.parts[i], expected.at(got.words[i]), 1e-6);
  }
  EXPECT_TRUE(fabmap::histogram_of(cv::Mat::zeros(80, 80, CV_8UC3), vocabulary).words.empty());
}

}  // namespace
}  // namespace sailmap::bow
