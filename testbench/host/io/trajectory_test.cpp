#include "sailmap/trajectory.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <string>

#include "error_matchers.hpp"
#include "host/map_builders.hpp"
#include "temporary_folder.hpp"

namespace sailmap {
namespace {

using ::testing::DoubleEq;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using testing::throws_naming;

class Trajectory : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file(const std::string& content) const {
    return folder_.file("poses.txt", content);
  }

  testing::TemporaryFolder folder_;
};

std::vector<double> position(const TimedPose& timed) {
  const cv::Vec3d t = timed.pose.translation();
  return {t[0], t[1], t[2]};
}

// Where the camera's x axis points.
std::vector<double> ahead(const TimedPose& timed) {
  const cv::Matx33d r = timed.pose.rotation();
  return {r(0, 0), r(1, 0), r(2, 0)};
}

constexpr double half = std::numbers::sqrt2 / 2;

TEST_F(Trajectory, OfTumHasTimesAndQuaternions) {
  // A quarter turn from x towards y.
  const auto poses =
      read_trajectory(file("1305031102.175304 1 2 3 0 0 0.7071067811865476 0.7071067811865476\n"));
  ASSERT_EQ(poses.size(), 1U);
  EXPECT_DOUBLE_EQ(poses[0].time, 1305031102.175304);
  EXPECT_THAT(position(poses[0]), ElementsAre(1, 2, 3));
  EXPECT_THAT(ahead(poses[0]), ElementsAre(DoubleNear(0, 1e-15), DoubleEq(1), DoubleEq(0)));
  const cv::Vec4d q = quaternion_of(poses[0].pose);
  EXPECT_NEAR(q[2], half, 1e-15);
  EXPECT_NEAR(q[3], half, 1e-15);
}

TEST_F(Trajectory, OfKittiHasMatricesAndNoTimes) {
  const auto poses = read_trajectory(file("0 -1 0 5 1 0 0 6 0 0 1 7\n"));
  EXPECT_TRUE(std::isnan(poses.at(0).time));
  EXPECT_THAT(position(poses[0]), ElementsAre(5, 6, 7));
  EXPECT_THAT(ahead(poses[0]), ElementsAre(DoubleNear(0, 1e-15), DoubleEq(1), DoubleEq(0)));
}

// Few digits leave a matrix a little off; what comes out is a rotation to the last digit.
TEST_F(Trajectory, RotationsComeOutOrthonormal) {
  const auto poses = read_trajectory(file("0.8660 -0.5 0 0 0.5 0.8660 0 0 0 0 1 0\n"));
  const cv::Matx33d r = poses.at(0).pose.rotation();
  EXPECT_LT(cv::norm(r * r.t() - cv::Matx33d::eye()), 1e-15);
  EXPECT_NEAR(r(1, 0), 0.5, 1e-4);
}

TEST_F(Trajectory, OfCsvHasWhatTheHeaderNames) {
  const auto plain = read_trajectory(file("x,y\n4,5\n"));
  EXPECT_THAT(position(plain.at(0)), ElementsAre(4, 5, 0));
  EXPECT_THAT(ahead(plain[0]), ElementsAre(1, 0, 0));
  EXPECT_TRUE(std::isnan(plain[0].time));
  const auto full = read_trajectory(file("Time,heading,y,x,z\n2.5,1.5707963267948966,5,4,6\n"));
  EXPECT_THAT(position(full.at(0)), ElementsAre(4, 5, 6));
  EXPECT_DOUBLE_EQ(full[0].time, 2.5);
  EXPECT_THAT(ahead(full[0]), ElementsAre(DoubleNear(0, 1e-15), DoubleEq(1), DoubleEq(0)));
  const auto turned = read_trajectory(file("x,y,qx,qy,qz,qw,timestamp\n0,0,1,0,0,0,3\n"));
  EXPECT_DOUBLE_EQ(std::abs(quaternion_of(turned.at(0).pose)[0]), 1);
  EXPECT_DOUBLE_EQ(turned[0].time, 3);
}

TEST_F(Trajectory, OfDegreesIsInMetresFromTheFirst) {
  const auto poses = read_trajectory(file("lat,lon,alt\n60,10,100\n60.001,10,101\n"));
  EXPECT_THAT(position(poses.at(0)), ElementsAre(0, 0, 100));
  EXPECT_NEAR(position(poses.at(1))[1], 111.4, 0.1);  // a thousandth of a degree of latitude at 60 degrees
}

TEST_F(Trajectory, FaultsNameTheLine) {
  for (const auto& [content, fault] : std::vector<std::pair<std::string, std::string>>{
           {"", "no pose"},
           {"0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 2\n", "length 1"},
           {"0 0 0 0 0 0 0 0\n", "length 1"},
           {"1 0 0 0 0 1 0 0 0 0 2 0\n", "no rotation"},
           {"1 0 0 0 0 1 0 0 0 0 -1 0\n", "no rotation"},  // a mirror
           {"x,y,time\n0,0,noon\n", "time"},
           {"x,y,time\n0,0\n", "time"},
           {"x,y,qx,qy,qz,qw\n0,0,1,1,1,1\n", "length 1"}}) {
    const auto path = file(content);
    EXPECT_THAT([&] { read_trajectory(path); }, throws_naming(path, fault)) << content;
  }
}

TEST(TimeFromName, IsSecondsOrAWholeUnixTime) {
  EXPECT_DOUBLE_EQ(time_from_name("rgb/1305031102.175304.png"), 1305031102.175304);
  EXPECT_DOUBLE_EQ(time_from_name("cam0/1403636579763555584.png"), 1403636579.763555584);
  EXPECT_DOUBLE_EQ(time_from_name("1403636579763.png"), 1403636579.763);
  EXPECT_DOUBLE_EQ(time_from_name("1403636579763555.png"), 1403636579.763555);
  EXPECT_DOUBLE_EQ(time_from_name("000017.png"), 17);
  EXPECT_TRUE(std::isnan(time_from_name("frame17.png")));
}

TopologicalMap map_named(const std::vector<std::string>& names) {
  TopologicalMap map(testing::small_map_config());
  int place = 0;
  for (const std::string& name : names) map.add(name, testing::image_of_place(place++));
  return map;
}

TEST(JoinByTime, TakesTheNearest) {
  std::vector<TimedPose> poses;
  for (const double time : {3.0, 1.0, 2.0}) poses.push_back({cv::Affine3d().translate({time, 0, 0}), time});
  const auto joined = join_by_time(map_named({"0.96.png", "1.4.png", "1.6.png", "3.04.png"}), poses, 0.5);
  std::vector<double> times;
  for (const TimedPose& pose : joined) times.push_back(pose.time);
  EXPECT_THAT(times, ElementsAre(1, 1, 2, 3));
  EXPECT_THROW(join_by_time(map_named({"3.6.png"}), poses, 0.5), Error);
  EXPECT_THROW(join_by_time(map_named({"start.png"}), poses, 0.5), Error);
  poses.push_back({});
  EXPECT_THROW(join_by_time(map_named({"1.png"}), poses, 0.5), Error);
}

TEST(JoinByNumber, WantsOneAnImage) {
  const TopologicalMap map = map_named({"a", "b"});
  EXPECT_EQ(join_by_number(map, std::vector<TimedPose>(2)).size(), 2U);
  EXPECT_THROW(join_by_number(map, std::vector<TimedPose>(1)), Error);
  EXPECT_THROW(join_by_number(map, std::vector<TimedPose>(3)), Error);
}

}  // namespace
}  // namespace sailmap
