// FAB-MAP against cases worked by hand, against a naive sum over all states, and against brute force.
#include "sailmap/fabmap.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <opencv2/imgproc.hpp>
#include <random>

#include "host/io/temporary_folder.hpp"
#include "sailmap/error.hpp"

namespace sailmap::fabmap {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// Words 0 and 1 always come together, 2 comes with 0 and 1 or not as chance has it.
const std::vector<Words> pairs = {{0, 1, 2}, {0, 1}, {2}, {}, {0, 1, 2}, {0, 1}, {2}, {}};

TEST(ChowLiu, JoinsWhatComesTogether) {
  const ChowLiuTree tree = learn_tree(pairs, 3);
  EXPECT_EQ(tree[0].parent, -1);
  EXPECT_EQ(tree[1].parent, 0);
  // Eight images, four with each word: (4 + 1/2) / (8 + 1), and of the four with word 0 all have word 1.
  EXPECT_DOUBLE_EQ(tree[0].marginal, 0.5);
  EXPECT_DOUBLE_EQ(tree[1].given_parent, 4.5 / 5);
  EXPECT_DOUBLE_EQ(tree[1].given_no_parent, 0.5 / 5);
  EXPECT_DOUBLE_EQ(tree[2].given_parent, 2.5 / 5);
  EXPECT_DOUBLE_EQ(tree[2].given_no_parent, 2.5 / 5);
}

// Mutual information of two words by the definition, from all images.
double information(const std::vector<Words>& images, int a, int b) {
  double joint[2][2] = {};
  for (const Words& words : images) {
    const auto has = [&words](int w) { return std::ranges::find(words, w) != words.end() ? 1 : 0; };
    joint[has(a)][has(b)] += 1.0 / static_cast<double>(images.size());
  }
  double sum = 0;
  for (int i = 0; i < 2; ++i) {
    for (int k = 0; k < 2; ++k) {
      const double of_a = joint[i][0] + joint[i][1];
      const double of_b = joint[0][k] + joint[1][k];
      if (joint[i][k] > 0) sum += joint[i][k] * std::log(joint[i][k] / (of_a * of_b));
    }
  }
  return sum;
}

std::vector<Words> random_images(int count, int words, std::mt19937& random) {
  std::vector<Words> images;
  for (int i = 0; i < count; ++i) {
    Words image;
    for (int w = 0; w < words; ++w) {
      if (random() % 3 == 0 || (w % 2 == 1 && !image.empty() && image.back() == w - 1 && random() % 4 != 0)) {
        image.push_back(w);
      }
    }
    images.push_back(image);
  }
  return images;
}

unsigned seed() {
  const unsigned value = std::random_device{}();
  std::cout << "seed " << value << '\n';
  return value;
}

// Of all trees over four words (by their parents), none has more mutual information.
TEST(ChowLiu, IsTheTreeOfMostInformation) {
  std::mt19937 random(seed());
  for (int run = 0; run < 50; ++run) {
    const std::vector<Words> images = random_images(25, 4, random);
    const ChowLiuTree tree = learn_tree(images, 4);
    double learned = 0;
    for (int w = 1; w < 4; ++w) learned += information(images, w, tree[static_cast<std::size_t>(w)].parent);
    double most = 0;
    for (int p1 = 0; p1 < 4; ++p1) {
      for (int p2 = 0; p2 < 4; ++p2) {
        for (int p3 = 0; p3 < 4; ++p3) {
          const int parents[4] = {0, p1, p2, p3};
          const auto reaches_root = [&parents](int w) {
            for (int step = 0; step < 4; ++step) w = parents[w];
            return w == 0;
          };
          if (!reaches_root(1) || !reaches_root(2) || !reaches_root(3)) continue;
          most = std::max(
              most, information(images, 1, p1) + information(images, 2, p2) + information(images, 3, p3));
        }
      }
    }
    EXPECT_NEAR(learned, most, 1e-12);
  }
}

TEST(ChowLiu, RefusesWhatItCannotLearnFrom) {
  EXPECT_THROW(learn_tree({}, 3), Error);
  EXPECT_THROW(learn_tree({{0, 3}}, 3), Error);
  EXPECT_THROW(learn_tree({{1, 0}}, 3), Error);
}

// One word without parent, marginal 1/2, detector 0.4 / 0. A place that shows it has the element for sure, so
// p(z=1) follows from the detector and the marginal: in favour 1/2 * 0.4 * 1/2, against 1/2 * 0.6 * 1/2, 0.4.
// One that does not has it with 0.6 * 1/2 / (0.6 * 1/2 + 1/2) = 3/8, so p(z=1) = 3/8 * 0.4 = 0.15.
TEST(Places, OneWordByHand) {
  FabmapConfig config;
  config.detect_present = 0.4;
  Places places({{-1, 0.5, 0.5, 0.5}}, config);
  places.add({0});
  places.add({});
  EXPECT_THAT(places.log_likelihoods({0}),
              ElementsAre(DoubleNear(std::log(0.4), 1e-12), DoubleNear(std::log(0.15), 1e-12)));
  EXPECT_THAT(places.log_likelihoods({}),
              ElementsAre(DoubleNear(std::log(0.6), 1e-12), DoubleNear(std::log(0.85), 1e-12)));
}

// Two words, the second seen with the first in 9 of 10 cases: seeing it alone is less likely than both, and a
// place with the first word alone explains both words better than one without any.
TEST(Places, TheTreeExplainsWordsThatComeTogether) {
  FabmapConfig config;
  config.detect_present = 0.4;
  Places places({{-1, 0.5, 0.5, 0.5}, {0, 0.5, 0.9, 0.1}}, config);
  places.add({0});
  places.add({});
  const auto both = places.log_likelihoods({0, 1});
  const auto alone = places.log_likelihoods({1});
  EXPECT_GT(both[0], both[1]);
  EXPECT_GT(both[0], alone[0]);
  // Of the place without words: the first word 0.15 as above; the second, its parent seen, has with the
  // element 0.9 * 0.4 / (0.9 * 0.4 + 0.1 * 0.6) = 6/7, so 3/8 * 6/7.
  EXPECT_NEAR(both[1], std::log(0.15) + std::log(3.0 / 8 * 6 / 7), 1e-12);
}

// log p(Z | place) by a sum over all words, no index.
double naive(const ChowLiuTree& tree, const FabmapConfig& config, const Words& place, const Words& image) {
  const auto has = [](const Words& words, int w) { return std::ranges::binary_search(words, w); };
  const auto either = [](bool value, double p) { return value ? p : 1 - p; };
  double sum = 0;
  for (int w = 0; w < static_cast<int>(tree.size()); ++w) {
    const TreeNode& node = tree[static_cast<std::size_t>(w)];
    const bool z = has(image, w);
    const double tree_seen = node.parent < 0           ? node.marginal
                             : has(image, node.parent) ? node.given_parent
                                                       : node.given_no_parent;
    double p = 0;
    double evidence = 0;
    for (const bool element : {false, true}) {
      const double detect = element ? config.detect_present : config.detect_absent;
      const double prior = either(element, node.marginal) * either(has(place, w), detect);
      const double alpha = either(z, node.marginal) * either(!z, detect) * either(!z, tree_seen);
      const double beta = either(!z, node.marginal) * either(z, detect) * either(z, tree_seen);
      p += prior / (1 + (beta == 0 ? INFINITY : alpha / beta));
      evidence += prior;
    }
    sum += std::log(p / evidence);
  }
  return sum;
}

TEST(Places, TheIndexIsExact) {
  std::mt19937 random(seed());
  const int words = 40;
  const std::vector<Words> images = random_images(60, words, random);
  const ChowLiuTree tree = learn_tree(images, words);
  Places places(tree, {});
  for (const Words& image : images) places.add(image);
  for (const Words& query : random_images(20, words, random)) {
    const auto got = places.log_likelihoods(query);
    for (std::size_t i = 0; i < images.size(); ++i) {
      EXPECT_NEAR(got[i], naive(tree, {}, images[i], query), 1e-9);
    }
  }
}

TEST(Places, RefuseBadNumbers) {
  EXPECT_THROW(Places({{-1, 1.0, 0.5, 0.5}}, {}), Error);
  EXPECT_THROW(Places({{5, 0.5, 0.5, 0.5}}, {}), Error);
  FabmapConfig config;
  config.detect_present = 1;
  EXPECT_THROW(Places({{-1, 0.5, 0.5, 0.5}}, config), Error);
  Places places({{-1, 0.5, 0.5, 0.5}}, {});
  EXPECT_THROW(places.add({1}), Error);
  EXPECT_THROW((void)places.log_likelihoods({-1}), Error);
}

Vocabulary of_words(const std::vector<Words>& training, int words) {
  return {cv::Mat::zeros(words, 128, CV_32F), learn_tree(training, words), training};
}

double probability(double log_odds) { return 1 / (1 + std::exp(-log_odds)); }

// Against p(L_i | Z) by Bayes' rule from the naive likelihoods; the new place is the mean of the samples.
TEST(LogOdds, AreThoseOfThePosterior) {
  std::mt19937 random(seed());
  const int words = 12;
  const std::vector<Words> samples = random_images(20, words, random);
  const Vocabulary vocabulary = of_words(samples, words);
  const FabmapConfig config;
  Fabmap fabmap(vocabulary, config);
  const std::vector<Words> images = random_images(6, words, random);
  for (const Words& image : images) fabmap.add(image);
  for (const Words& query : random_images(10, words, random)) {
    const std::size_t count = 1 + random() % images.size();
    double total = 0;
    for (const Words& sample : samples) {
      total += config.new_place_prior / 20 * std::exp(naive(vocabulary.tree, config, sample, query));
    }
    std::vector<double> joint;
    for (std::size_t i = 0; i < count; ++i) {
      joint.push_back((1 - config.new_place_prior) / static_cast<double>(count) *
                      std::exp(naive(vocabulary.tree, config, images[i], query)));
      total += joint.back();
    }
    const std::vector<double> got = fabmap.log_odds(query, count);
    ASSERT_EQ(got.size(), count);
    for (std::size_t i = 0; i < count; ++i) EXPECT_NEAR(probability(got[i]), joint[i] / total, 1e-9);
  }
}

TEST(LogOdds, TheSameImageIsMostLikely) {
  std::mt19937 random(seed());
  const int words = 60;
  Fabmap fabmap(of_words(random_images(100, words, random), words), {});
  const std::vector<Words> images = random_images(30, words, random);
  for (const Words& image : images) fabmap.add(image);
  for (std::size_t i = 0; i < images.size(); ++i) {
    const std::vector<double> odds = fabmap.log_odds(images[i], images.size());
    EXPECT_EQ(std::ranges::max_element(odds) - odds.begin(), static_cast<std::ptrdiff_t>(i));
  }
}

TEST(LogOdds, OfNoPlacesAreNone) {
  Fabmap fabmap(of_words(pairs, 3), {});
  fabmap.add({0, 1});
  EXPECT_TRUE(fabmap.log_odds({2}, 0).empty());
  EXPECT_EQ(fabmap.log_odds({2}, 5).size(), 1U);
}

// Row by row what log_odds says; places that came later do not count.
TEST(Scores, AreTheLogOddsOfThePlacesBefore) {
  std::mt19937 random(seed());
  const int words = 30;
  const Vocabulary vocabulary = of_words(random_images(40, words, random), words);
  const std::vector<Words> images = random_images(9, words, random);
  const Plane<float> scores = score_sequence(images, 2, vocabulary);
  Fabmap fabmap(vocabulary, {});
  for (int q = 0; q < 9; ++q) {
    const auto query = static_cast<std::size_t>(q);
    const std::vector<double> expected = fabmap.log_odds(images[query], fabmap.size());
    for (int c = 0; c < 9; ++c) {
      if (c < q - 2) {
        EXPECT_FLOAT_EQ(scores(c, q), static_cast<float>(expected[static_cast<std::size_t>(c)]));
      } else {
        EXPECT_TRUE(std::isnan(scores(c, q)));
      }
    }
    if (q >= 2) fabmap.add(images[query - 2]);
  }
  EXPECT_THROW(score_sequence(images, -1, vocabulary), Error);
  const Plane<float> traverses = score_traverses(images, {images[4], images[1]}, vocabulary);
  ASSERT_EQ(traverses.width(), 2);
  ASSERT_EQ(traverses.height(), 9);
  EXPECT_GT(traverses(0, 4), traverses(1, 4));
  EXPECT_LT(traverses(0, 1), traverses(1, 1));
}

// A second lap whose images are known one by one but for the last, which two places explain alike: the
// sequence tells them apart. Without a filter nothing changes.
TEST(Scores, AreFilteredAsProbabilities) {
  constexpr int lap = 12;
  Plane<float> scores(lap, lap, -6);
  for (int q = 0; q < lap; ++q) scores(q, q) = 200;
  scores(lap - 1, lap - 1) = 1;
  scores(2, lap - 1) = 1.5F;
  const Plane<float> same = filter_log_odds(scores, 0);
  EXPECT_TRUE(std::ranges::equal(same.samples(), scores.samples()));
  const Plane<float> filtered = filter_log_odds(scores, 10);
  EXPECT_GT(filtered(lap - 1, lap - 1), filtered(2, lap - 1));
  for (const float value : filtered.samples()) EXPECT_TRUE(std::isfinite(value));
  for (int q = 0; q + 1 < lap; ++q) {
    for (int c = 0; c < lap; ++c) EXPECT_GE(filtered(q, q), filtered(c, q));
  }
}

cv::Mat scene(unsigned place) {
  cv::Mat image(120, 160, CV_8UC3, cv::Scalar(90, 90, 90));
  std::mt19937 random(place);
  for (int i = 0; i < 30; ++i) {
    const cv::Point at(static_cast<int>(random() % 150), static_cast<int>(random() % 110));
    const auto level = [&random] { return static_cast<double>(random() % 256); };
    const cv::Scalar colour(level(), level(), level());
    cv::rectangle(image, at,
                  at + cv::Point(5 + static_cast<int>(random() % 20), 5 + static_cast<int>(random() % 20)),
                  colour, -1);
  }
  return image;
}

TEST(Training, MakesAVocabularyThatRecognises) {
  std::vector<cv::Mat> images;
  for (unsigned place = 0; place < 12; ++place) images.push_back(scene(place));
  TrainingConfig config;
  config.words = 40;
  const auto image = [&images](std::size_t i) { return images[i]; };
  const Vocabulary vocabulary = train(images.size(), image, config);
  EXPECT_EQ(vocabulary.centres.rows, 40);
  EXPECT_EQ(vocabulary.training.size(), images.size());
  EXPECT_EQ(histogram_of(images[3], vocabulary).words, vocabulary.training[3]);
  Fabmap fabmap(vocabulary, {});
  for (unsigned place = 100; place < 106; ++place) fabmap.add(histogram_of(scene(place), vocabulary).words);
  const std::vector<double> odds = fabmap.log_odds(histogram_of(scene(102), vocabulary).words, 6);
  EXPECT_EQ(std::ranges::max_element(odds) - odds.begin(), 2);
  config.words = 100000;
  EXPECT_THAT([&] { train(images.size(), image, config); },
              ThrowsMessage<Error>(HasSubstr("too few for 100000 words")));
}

TEST(VocabularyFile, IsReadAsWritten) {
  const testing::TemporaryFolder folder;
  Vocabulary written = of_words(pairs, 3);
  written.features = 321;
  write_vocabulary(folder.path() / "v.json", written);
  const Vocabulary read = read_vocabulary(folder.path() / "v.json");
  EXPECT_EQ(read.training, written.training);
  EXPECT_EQ(read.features, 321);
  EXPECT_EQ(cv::countNonZero(read.centres != written.centres), 0);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read.tree[i].parent, written.tree[i].parent);
    EXPECT_EQ(read.tree[i].given_parent, written.tree[i].given_parent);
  }
}

TEST(VocabularyFile, DamageIsNamed) {
  const testing::TemporaryFolder folder;
  const auto expect_fault = [&](const std::string& text, const std::string& fault) {
    const auto path = folder.file("v.json", text);
    EXPECT_THAT([&] { read_vocabulary(path); },
                ThrowsMessage<Error>(AllOf(HasSubstr("v.json: "), HasSubstr(fault))));
  };
  expect_fault("", "damaged");
  expect_fault("{}", "damaged");
  expect_fault(R"({"format": "else"})", "not a sailmap vocabulary");
  expect_fault(R"({"format": "sailmap fabmap vocabulary", "version": 9})", "version 9");
  expect_fault(
      R"({"format": "sailmap fabmap vocabulary", "version": 1, "features": 500, "centres": [], "tree": [],
          "training": []})",
      "0 words");
  EXPECT_THAT([&] { read_vocabulary(folder.path() / "none.json"); },
              ThrowsMessage<Error>(HasSubstr("none.json")));
}

}  // namespace
}  // namespace sailmap::fabmap
