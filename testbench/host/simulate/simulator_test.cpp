#include "sailmap/simulator.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <iostream>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <thread>
#include <vector>

#include "sailmap/error.hpp"
#include "temporary_folder.hpp"

namespace sailmap {
namespace {

SimulationConfig small() {
  SimulationConfig config;
  config.width = 160;
  config.height = 120;
  config.images_per_lap = 90;
  return config;
}

double difference(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_L1) / static_cast<double>(a.total() * 3);
}

TEST(Simulator, GivesAnImageOfTheSizeAskedFor) {
  for (const cv::Size size : {cv::Size(64, 64), cv::Size(333, 77), cv::Size(640, 480)}) {
    SimulationConfig config = small();
    config.width = size.width;
    config.height = size.height;
    const cv::Mat image = Simulator(config).render(3);
    EXPECT_EQ(image.size(), size);
    EXPECT_EQ(image.type(), CV_8UC3);
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(image, mean, deviation);
    EXPECT_GT(deviation[0], 15);  // a picture, not a plain area
  }
}

TEST(Simulator, ImageDependsOnConfigurationAndIndexOnly) {
  const SimulationConfig config = small();
  const Simulator forwards(config);
  std::vector<cv::Mat> images;
  for (int i = 0; i < 130; i += 10) images.push_back(forwards.render(i));
  const Simulator backwards(config);
  for (int i = 120; i >= 0; i -= 10)
    EXPECT_EQ(difference(images[static_cast<std::size_t>(i / 10)], backwards.render(i)), 0) << i;
  SimulationConfig longer = config;
  longer.images = 9999;  // how many are wanted makes no difference to any of them
  EXPECT_EQ(difference(images[4], Simulator(longer).render(40)), 0);
}

TEST(Simulator, MayBeUsedFromSeveralThreads) {
  const Simulator simulator(small());
  const Simulator alone(small());
  std::vector<cv::Mat> images(8);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (int i = t; i < 8; i += 4) images[static_cast<std::size_t>(i)] = simulator.render(11 * i);
    });
  for (std::thread& thread : threads) thread.join();
  for (int i = 0; i < 8; ++i)
    EXPECT_EQ(difference(images[static_cast<std::size_t>(i)], alone.render(11 * i)), 0) << i;
}

TEST(Simulator, OtherSeedsAreOtherWorlds) {
  SimulationConfig config = small();
  std::vector<cv::Mat> images;
  for (config.seed = 1; config.seed <= 4; ++config.seed) images.push_back(Simulator(config).render(10));
  for (std::size_t i = 0; i < images.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT(difference(images[i], images[j]), 15) << i << ' ' << j;
}

TEST(Simulator, WithoutChangesTheSecondLapIsTheFirst) {
  SimulationConfig config = small();
  config.jitter = 0;
  config.lighting = 0;
  config.moving_objects = 0;
  const Simulator simulator(config);
  for (const int i : {0, 1, 44, 89}) {
    EXPECT_EQ(difference(simulator.render(i), simulator.render(i + 90)), 0) << i;
    EXPECT_EQ(difference(simulator.render(i), simulator.render(i + 90 * 7)), 0) << i;
  }
  EXPECT_GT(difference(simulator.render(0), simulator.render(1)), 3);
}

// Each of the three changes the second lap by itself, so none of the settings is idle.
TEST(Simulator, EachChangeChangesTheSecondLap) {
  for (int which = 0; which < 3; ++which) {
    SimulationConfig config = small();
    config.jitter = which == 0 ? 1 : 0;
    config.lighting = which == 1 ? 1 : 0;
    config.moving_objects = which == 2 ? 20 : 0;
    const Simulator simulator(config);
    double sum = 0;
    for (int i = 0; i < 90; i += 15) sum += difference(simulator.render(i), simulator.render(i + 90)) / 6;
    EXPECT_GT(sum, 1) << which;
    if (which != 0) {
      EXPECT_EQ(simulator.pose(7).x, simulator.pose(97).x);
      EXPECT_EQ(simulator.pose(7).heading, simulator.pose(97).heading);
    } else {
      EXPECT_NE(simulator.pose(7).x, simulator.pose(97).x);
    }
  }
}

TEST(Simulator, ConsecutiveImagesAreAMetreAndAHalfApart) {
  SimulationConfig config = small();
  config.jitter = 0;
  config.images_per_lap = 5000;
  const Simulator simulator(config);
  double travelled = 0;
  for (int i = 0; i < 5000; ++i) {
    const SimulatedPose a = simulator.pose(i);
    const SimulatedPose b = simulator.pose(i + 1);
    const double step = std::hypot(b.x - a.x, b.y - a.y);
    EXPECT_GT(step, 1.1);
    EXPECT_LT(step, 1.9);
    travelled += step;
  }
  EXPECT_NEAR(travelled / 5000, 1.5, 0.05);
}

TEST(Simulator, IsEndless) {
  SimulationConfig config = small();
  config.images_per_lap = 5000;
  const Simulator simulator(config);
  for (const int i : {1'000'000, std::numeric_limits<int>::max()}) {
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(simulator.render(i), mean, deviation);
    EXPECT_GT(deviation[1], 15) << i;
  }
}

TEST(Simulator, WorksInTheSmallestCircuitAndUnderWildSettings) {
  SimulationConfig config = small();
  config.images_per_lap = 2;
  config.jitter = 10;
  config.lighting = 10;
  config.moving_objects = 200;
  for (config.seed = 0; config.seed < 12; ++config.seed) {
    const Simulator simulator(config);
    for (int i = 0; i < 4; ++i) EXPECT_FALSE(simulator.render(i).empty());
  }
}

TEST(Simulator, FrontsShowTheTextures) {
  const testing::TemporaryFolder folder;
  cv::imwrite((folder.path() / "magenta.png").string(), cv::Mat(300, 900, CV_8UC3, cv::Scalar(255, 0, 255)));
  cv::imwrite((folder.path() / "tiny.png").string(), cv::Mat(1, 1, CV_8UC3, cv::Scalar(255, 0, 255)));
  SimulationConfig config = small();
  config.lighting = 0;
  const auto magenta = [](const cv::Mat& image) {
    int count = 0;
    for (int y = 0; y < image.rows; ++y)
      for (int x = 0; x < image.cols; ++x) {
        const auto& p = image.at<cv::Vec3b>(y, x);
        count += p[0] > 2 * p[1] + 30 && p[2] > 2 * p[1] + 30 ? 1 : 0;
      }
    return static_cast<double>(count) / static_cast<double>(image.total());
  };
  double drawn = 0;
  double photographed = 0;
  const Simulator without(config);
  config.textures = folder.path();
  const Simulator with(config);
  for (int i = 0; i < 90; i += 15) {
    drawn += magenta(without.render(i)) / 6;
    photographed += magenta(with.render(i)) / 6;
  }
  EXPECT_GT(photographed, 0.15);
  EXPECT_LT(drawn, 0.05);
}

void expect_error(const SimulationConfig& config, const std::string& part) {
  try {
    const Simulator simulator(config);
    ADD_FAILURE() << "accepted; expected a complaint about " << part;
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr(part));
    EXPECT_THAT(error.what(), ::testing::Not(::testing::HasSubstr("\n")));
  }
}

TEST(Simulator, RefusesWhatIsOutOfRange) {
  const auto changed = [](auto change) {
    SimulationConfig config = small();
    change(config);
    return config;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_error(changed([](auto& c) { c.images = 0; }), "images is 0");
  expect_error(changed([](auto& c) { c.width = 63; }), "width is 63");
  expect_error(changed([](auto& c) { c.height = 4097; }), "height is 4097");
  expect_error(changed([](auto& c) { c.images_per_lap = 1; }), "images_per_lap is 1");
  expect_error(changed([](auto& c) { c.images_per_lap = 100'001; }), "images_per_lap");
  expect_error(changed([](auto& c) { c.jitter = -0.1; }), "jitter is -0.1");
  expect_error(changed([&](auto& c) { c.jitter = nan; }), "jitter");
  expect_error(changed([&](auto& c) { c.lighting = nan; }), "lighting");
  expect_error(changed([](auto& c) { c.moving_objects = -1; }), "moving_objects is -1");
  expect_error(changed([](auto& c) { c.match_radius = 0; }), "match_radius is 0");
  expect_error(changed([](auto& c) { c.match_radius = std::numeric_limits<double>::infinity(); }),
               "match_radius");
  expect_error(changed([](auto& c) { c.textures = "/nowhere/at-all"; }), "/nowhere/at-all");
  const testing::TemporaryFolder empty;
  expect_error(changed([&](auto& c) { c.textures = empty.path(); }), empty.path().string());
  const Simulator simulator(small());
  EXPECT_THROW(static_cast<void>(simulator.render(-1)), Error);
  EXPECT_THROW(static_cast<void>(simulator.pose(-1)), Error);
}

TEST(Simulator, Speed) {
  SimulationConfig config;
  config.images_per_lap = 500;
  const Simulator simulator(config);
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  const std::clock_t start = std::clock();  // processor time: other programs may be busy
  for (int i = 0; i < 40; ++i) ASSERT_FALSE(simulator.render(i).empty());
  const double taken = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  cv::setNumThreads(threads);
  std::cout << "320x240: " << 40 / taken << " images/s on one core\n";
}

}  // namespace
}  // namespace sailmap
