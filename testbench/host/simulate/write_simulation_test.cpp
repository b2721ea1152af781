#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "sailmap/error.hpp"
#include "sailmap/simulator.hpp"
#include "temporary_folder.hpp"

namespace sailmap {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

SimulationConfig small() {
  SimulationConfig config;
  config.images = 12;
  config.images_per_lap = 5;
  config.match_radius = 4;
  config.width = 96;
  config.height = 64;
  config.seed = 1234567890123456789ULL;
  return config;
}

std::vector<std::string> lines_of(const fs::path& path) {
  std::ifstream in(path);
  EXPECT_TRUE(in) << path;
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    if (line.empty() || line[0] != '#') lines.push_back(line);
  return lines;
}

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

class WriteSimulation : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new testing::TemporaryFolder;
    write_simulation(sequence(), small(), [](int done) { progress.push_back(done); });
  }
  static void TearDownTestSuite() {
    delete folder;
    folder = nullptr;
  }
  static fs::path sequence() { return folder->path() / "new" / "sequence"; }

  static inline testing::TemporaryFolder* folder = nullptr;
  static inline std::vector<int> progress;
};

TEST_F(WriteSimulation, HoldsTheImages) {
  const Simulator simulator(small());
  EXPECT_EQ(entries(sequence() / "images"), 12U);
  for (const int i : {0, 7, 11}) {
    std::string number = std::to_string(i);
    number.insert(0, 6 - number.size(), '0');
    const cv::Mat image = cv::imread((sequence() / "images" / (number + ".png")).string(), cv::IMREAD_COLOR);
    ASSERT_FALSE(image.empty()) << i;
    EXPECT_EQ(cv::norm(image, simulator.render(i), cv::NORM_INF), 0);
  }
  EXPECT_EQ(entries(sequence()), 5U);  // nothing but what the header promises
  EXPECT_EQ(progress, (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
}

TEST_F(WriteSimulation, PosesAreExact) {
  const Simulator simulator(small());
  const std::vector<std::string> tum = lines_of(sequence() / "poses.txt");
  const std::vector<std::string> csv = lines_of(sequence() / "poses.csv");
  ASSERT_EQ(tum.size(), 12U);
  ASSERT_EQ(csv.size(), 13U);
  EXPECT_EQ(csv[0], "x,y,heading");
  for (std::size_t i = 0; i < 12; ++i) {
    const SimulatedPose pose = simulator.pose(static_cast<int>(i));
    double time = 0;
    double x = 0;
    double y = 0;
    double z = 0;
    double qx = 0;
    double qy = 0;
    double qz = 0;
    double qw = 0;
    std::istringstream line(tum[i]);
    ASSERT_TRUE(line >> time >> x >> y >> z >> qx >> qy >> qz >> qw) << tum[i];
    EXPECT_DOUBLE_EQ(time, 0.5 * static_cast<double>(i));
    EXPECT_EQ(x, pose.x);
    EXPECT_EQ(y, pose.y);
    EXPECT_GT(z, 1);
    EXPECT_NEAR(qx * qx + qy * qy + qz * qz + qw * qw, 1, 1e-12);
    // Where the quaternion turns the x axis: along the heading, a little upwards.
    const double forward_x = 1 - 2 * (qy * qy + qz * qz);
    const double forward_y = 2 * (qx * qy + qz * qw);
    const double forward_z = 2 * (qx * qz - qy * qw);
    EXPECT_NEAR(std::atan2(forward_y, forward_x), pose.heading, 1e-12);
    EXPECT_GT(forward_z, 0);
    EXPECT_LT(forward_z, 0.2);
    // The y axis (left) stays nearly level.
    EXPECT_LT(std::abs(2 * (qy * qz + qx * qw)), 0.05);

    char comma = 0;
    double heading = 0;
    std::istringstream row(csv[i + 1]);
    ASSERT_TRUE(row >> x >> comma >> y >> comma >> heading) << csv[i + 1];
    EXPECT_EQ(x, pose.x);
    EXPECT_EQ(y, pose.y);
    EXPECT_EQ(heading, pose.heading);
  }
}

TEST_F(WriteSimulation, GroundTruthIsTheSimulators) {
  std::vector<std::vector<int>> matches(12);
  for (const std::string& line : lines_of(sequence() / "ground_truth.txt")) {
    std::istringstream in(line);
    std::size_t query = 0;
    char colon = 0;
    ASSERT_TRUE(in >> query >> colon) << line;
    ASSERT_EQ(colon, ':');
    for (int match = 0; in >> match;) matches.at(query).push_back(match);
  }
  EXPECT_EQ(matches, Simulator(small()).ground_truth().matches);
  EXPECT_THAT(matches[11], ::testing::ElementsAre(1, 6));  // laps of five images 20 m apart
}

TEST_F(WriteSimulation, ParametersAreComplete) {
  const auto json = nlohmann::json::parse(std::ifstream(sequence() / "simulation.json"));
  EXPECT_EQ(json.at("seed").get<std::uint64_t>(), small().seed);
  EXPECT_EQ(json.at("images"), 12);
  EXPECT_EQ(json.at("width"), 96);
  EXPECT_EQ(json.at("height"), 64);
  EXPECT_EQ(json.at("images_per_lap"), 5);
  EXPECT_EQ(json.at("jitter"), 1);
  EXPECT_EQ(json.at("lighting"), 1);
  EXPECT_EQ(json.at("moving_objects"), 6);
  EXPECT_EQ(json.at("match_radius"), 4);
  EXPECT_EQ(json.at("textures"), "");
  EXPECT_EQ(json.at("circuit_metres"), 100);
}

TEST_F(WriteSimulation, RefusesAFolderThatHoldsASequence) {
  const auto before = fs::last_write_time(sequence() / "images" / "000000.png");
  try {
    write_simulation(sequence(), small(), nullptr);
    ADD_FAILURE() << "written over";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr(sequence().string()));
    EXPECT_THAT(error.what(), HasSubstr("holds a sequence already"));
  }
  EXPECT_EQ(fs::last_write_time(sequence() / "images" / "000000.png"), before);
  const testing::TemporaryFolder other;
  std::ofstream(other.path() / "poses.csv") << "x,y\n";
  EXPECT_THROW(write_simulation(other.path(), small(), nullptr), Error);
}

TEST(WriteSimulationErrors, LeaveNothingBehind) {
  const testing::TemporaryFolder folder;
  const auto stop = [](int done) {
    if (done == 3) throw std::runtime_error("stop");
  };
  EXPECT_THROW(write_simulation(folder.path() / "a" / "b", small(), stop), std::runtime_error);
  EXPECT_FALSE(fs::exists(folder.path() / "a"));
  // A folder that was there, with something in it, stays as it was.
  std::ofstream(folder.path() / "notes.txt") << "mine\n";
  EXPECT_THROW(write_simulation(folder.path(), small(), stop), std::runtime_error);
  EXPECT_EQ(entries(folder.path()), 1U);
  // And can be used all the same.
  SimulationConfig config = small();
  config.images = 2;
  write_simulation(folder.path(), config, nullptr);
  EXPECT_EQ(entries(folder.path()), 6U);
}

TEST(WriteSimulationErrors, NameTheFault) {
  const testing::TemporaryFolder folder;
  std::ofstream(folder.path() / "file") << "x";
  try {
    write_simulation(folder.path() / "file" / "below", small(), nullptr);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr((folder.path() / "file").string()));
  }
  SimulationConfig config = small();
  config.width = 10;
  EXPECT_THROW(write_simulation(folder.path() / "never", config, nullptr), Error);
  EXPECT_FALSE(fs::exists(folder.path() / "never"));
}

}  // namespace
}  // namespace sailmap
