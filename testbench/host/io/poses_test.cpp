#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "error_matchers.hpp"
#include "sailmap/ground_truth.hpp"
#include "temporary_folder.hpp"

namespace sailmap {
namespace {

using ::testing::DoubleEq;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::IsEmpty;
using testing::throws_naming;

auto pose(double x, double y) { return AllOf(Field(&Pose::x, DoubleEq(x)), Field(&Pose::y, DoubleEq(y))); }

class Poses : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file(const std::string& content,
                                           const std::string& name = "poses.txt") const {
    return folder_.file(name, content);
  }

  testing::TemporaryFolder folder_;
};

TEST_F(Poses, OfKittiLieInXAndZ) {
  const auto path = file("1 0 0 5 0 1 0 6 0 0 1 7\n1 0 0 -1.5e+00 0 1 0 2 0 0 1 3.25\n");
  EXPECT_THAT(read_poses(path), ElementsAre(pose(5, 7), pose(-1.5, 3.25)));
}

TEST_F(Poses, OfTumLieInXAndY) {
  const auto path =
      file("# time x y z qx qy qz qw\n1305031102.1758 1 2 3 0 0 0 1\n1305031103 4 5 6 0 0 0 1\n");
  EXPECT_THAT(read_poses(path), ElementsAre(pose(1, 2), pose(4, 5)));
}

TEST_F(Poses, OfCsvAreFoundByTheHeader) {
  EXPECT_THAT(read_poses(file("name, Y ,x\na.png,2,1\nb.png, 4 ,3\n")), ElementsAre(pose(1, 2), pose(3, 4)));
}

// The radius of curvature of the WGS84 ellipsoid along the meridian, and of the parallel, at a latitude in
// degrees.
constexpr double equatorial_radius = 6378137;
constexpr double eccentricity_squared = 6.69437999014e-3;
double squeeze(double latitude) {
  const double sine = std::sin(latitude * std::numbers::pi / 180);
  return 1 - eccentricity_squared * sine * sine;
}
double metres_north_per_degree(double latitude) {
  return equatorial_radius * (1 - eccentricity_squared) / std::pow(squeeze(latitude), 1.5) *
         std::numbers::pi / 180;
}
double metres_east_per_degree(double latitude) {
  return equatorial_radius / std::sqrt(squeeze(latitude)) * std::cos(latitude * std::numbers::pi / 180) *
         std::numbers::pi / 180;
}

TEST_F(Poses, OfGnssAreMetresFromTheFirst) {
  const auto poses = read_poses(file("timestamp,lat,lon\n0,51.75,-1.26\n1,51.751,-1.26\n2,51.75,-1.259\n"));
  ASSERT_EQ(poses.size(), 3U);
  EXPECT_THAT(poses[0], pose(0, 0));
  EXPECT_THAT(poses[1].x, DoubleNear(0, 1e-3));
  EXPECT_THAT(poses[1].y, DoubleNear(0.001 * metres_north_per_degree(51.75), 0.01));
  EXPECT_THAT(poses[2].x, DoubleNear(0.001 * metres_east_per_degree(51.75), 0.01));
  EXPECT_THAT(poses[2].y, DoubleNear(0, 1e-3));
}

TEST_F(Poses, NameFileLineAndFault) {
  struct Case {
    const char *content, *line, *fault;
  };
  for (const Case& c :
       {Case{"1 2 3\n", ":1", "neither a KITTI pose"},
        Case{"1 0 0 5 0 1 0 6 0 0 1 7\n1 0 0 5 0 1 0 6 0 0 1\n", ":2", "a KITTI pose has 12 numbers"},
        Case{"1 2 3 4 5 6 7 8\n\n1 2 3 4 5 6 7 x\n", ":3", "a TUM pose has 8 numbers"},
        Case{"1 2 3 4 5 6 7 nan\n", ":1", "a TUM pose has 8 numbers"},
        Case{"a,b\n1,2\n", ":1", "must name x,y or lat,lon"},
        Case{"1,2\n3,4\n", ":1", "must name x,y or lat,lon"}, Case{"x,y\n1,2\n1\n", ":3", "too few fields"},
        Case{"x,y\n1,\n", ":2", "not two numbers"}, Case{"x,y\n1,inf\n", ":2", "not two numbers"},
        Case{"lat,lon\n91,0\n", ":2", "latitude must be -90..90"},
        Case{"lat,lon\n0,181\n", ":2", "longitude -180..180"}, Case{"x,y\n", "", "no pose after the header"},
        Case{"# nothing\n", "", "no pose in this file"}}) {
    const auto path = file(c.content);
    EXPECT_THAT([&] { read_poses(path); }, throws_naming(path.string() + c.line, c.fault)) << c.content;
  }
}

TEST_F(Poses, WithinTheRadiusShowTheSamePlace) {
  const std::vector<Pose> walk = {{0, 0}, {3, 4}, {10, 0}, {0, 0}};
  EXPECT_THAT(ground_truth_from_poses(walk, walk, 5, true).matches,
              ElementsAre(ElementsAre(1, 3), ElementsAre(0, 3), IsEmpty(), ElementsAre(0, 1)));
  EXPECT_THAT(ground_truth_from_poses(walk, {{3, 4}, {10, 1}}, 4.999, false).matches,
              ElementsAre(IsEmpty(), ElementsAre(0), ElementsAre(1), IsEmpty()));
  EXPECT_THAT(ground_truth_from_poses(walk, {}, 5, false).matches, ::testing::Each(IsEmpty()));
}

TEST_F(Poses, NeedARadius) {
  for (const double radius : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THAT(
        [&] {
          ground_truth_from_poses({{0, 0}}, {{0, 0}}, radius, true);
        },
        ::testing::ThrowsMessage<Error>(::testing::HasSubstr("radius")));
  }
}

TEST_F(Poses, GiveTheSameMatchesAsComparingAll) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-100, 100);
  std::vector<Pose> queries(400);
  std::vector<Pose> candidates(500);
  for (Pose& p : queries) p = {place(random), place(random)};
  for (Pose& p : candidates) p = {place(random), place(random)};
  for (const double radius : {1.0, 15.0, 400.0}) {
    const auto truth = ground_truth_from_poses(queries, candidates, radius, false);
    for (std::size_t q = 0; q < queries.size(); ++q) {
      std::vector<int> near;
      for (std::size_t c = 0; c < candidates.size(); ++c) {
        const double dx = queries[q].x - candidates[c].x;
        const double dy = queries[q].y - candidates[c].y;
        if (dx * dx + dy * dy <= radius * radius) near.push_back(static_cast<int>(c));
      }
      ASSERT_EQ(truth.matches[q], near);
    }
  }
}

// A drive of 20 000 images a metre apart, there and back.
TEST_F(Poses, OfALongDriveAreMatched) {
  constexpr int half = 10000;
  std::vector<Pose> drive;
  for (int i = 0; i < 2 * half; ++i)
    drive.push_back({static_cast<double>(i < half ? i : 2 * half - 1 - i), 0});
  const auto truth = ground_truth_from_poses(drive, drive, 2, true);
  EXPECT_THAT(truth.matches[5000], ElementsAre(4998, 4999, 5001, 5002, 14997, 14998, 14999, 15000, 15001));
  EXPECT_THAT(truth.matches[0], ElementsAre(1, 2, 19997, 19998, 19999));
}

TEST_F(Poses, OfOneSequenceMustBeOneAnImage) {
  const auto path = file("x,y\n0,0\n9,0\n1,0\n");
  EXPECT_THAT(read_ground_truth(path, {.queries = 3, .candidates = 3, .radius = 2}).matches,
              ElementsAre(ElementsAre(2), IsEmpty(), ElementsAre(0)));
  EXPECT_THAT([&] { read_ground_truth(path, {.queries = 4, .candidates = 4, .radius = 2}); },
              throws_naming(path, "3 poses for 4 images"));
  EXPECT_THAT([&] { read_ground_truth(path, {.queries = 3, .candidates = 3, .radius = 0}); },
              ::testing::ThrowsMessage<Error>(::testing::HasSubstr("radius")));
  EXPECT_THAT(
      [&] { read_ground_truth(path, {.queries = 3, .candidates = 3, .same_sequence = false, .radius = 2}); },
      throws_naming(path, "two traverses need a file each"));
}

TEST_F(Poses, OfTwoTraversesShareOnePlane) {
  // The second traverse begins 111 m further north: with an origin each, its first image would match the
  // first.
  const auto queries = file("lat,lon\n51.751,-1.26\n51.752,-1.26\n", "queries.csv");
  const auto candidates = file("lat,lon\n51.75,-1.26\n51.75101,-1.26\n51.9,-1.26\n", "candidates.csv");
  const GroundTruthOptions options{.queries = 2, .candidates = 3, .same_sequence = false, .radius = 5};
  EXPECT_THAT(read_ground_truth(queries, candidates, options).matches,
              ElementsAre(ElementsAre(1), IsEmpty()));
}

TEST_F(Poses, OfTwoTraversesMustAgreeInUnitAndNumber) {
  const auto degrees = file("lat,lon\n51.751,-1.26\n", "degrees.csv");
  const auto metres = file("x,y\n0,0\n", "metres.csv");
  EXPECT_THAT([&] { read_ground_truth(degrees, metres, {.queries = 1, .candidates = 1, .radius = 5}); },
              ::testing::ThrowsMessage<Error>(
                  AllOf(::testing::HasSubstr(degrees.string()), ::testing::HasSubstr("one has degrees"))));
  EXPECT_THAT([&] { read_ground_truth(metres, metres, {.queries = 1, .candidates = 2, .radius = 5}); },
              throws_naming(metres, "1 poses for 2 images"));
}

}  // namespace
}  // namespace sailmap
