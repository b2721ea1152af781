// Each perturbation against what it must do to pictures made by hand.
#include "sailmap/perturbation.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "sailmap/error.hpp"

namespace sailmap {
namespace {

using Kind = PerturbationKind;

cv::Mat dotted() {
  cv::Mat image(90, 120, CV_8UC3, cv::Scalar(40, 60, 80));
  image(cv::Rect(78, 40, 6, 6)).setTo(cv::Scalar(200, 160, 240));
  return image;
}

cv::Point2d middle_of_dot(const cv::Mat& image) {
  cv::Mat red;
  cv::extractChannel(image, red, 2);
  const cv::Moments m = cv::moments(red > 160, true);
  return {m.m10 / m.m00, m.m01 / m.m00};
}

void expect_dot(const cv::Mat& image, double x, double y) {
  const cv::Point2d dot = middle_of_dot(image);
  EXPECT_NEAR(dot.x, x, 0.6);
  EXPECT_NEAR(dot.y, y, 0.6);
}

// The dot's middle is (80.5, 42.5), the image's (59.5, 44.5).
TEST(Perturbation, GeometryMovesTheDotWhereItShould) {
  expect_dot(perturb(dotted(), Kind::shift, 0.1, 1), 92.5, 42.5);
  expect_dot(perturb(dotted(), Kind::shift, -0.25, 1), 50.5, 42.5);
  expect_dot(perturb(dotted(), Kind::rotate, 90, 1), 59.5 - 2, 44.5 - 21);
  expect_dot(perturb(dotted(), Kind::scale, 0.5, 1), 59.5 + 10.5, 44.5 - 1);
  expect_dot(perturb(dotted(), Kind::crop, 0.5, 1), 59.5 + 42, 44.5 - 4);
}

TEST(Perturbation, TonesFollowTheirFormulas) {
  EXPECT_EQ(perturb(dotted(), Kind::brightness, 0.5, 1).at<cv::Vec3b>(0, 0), cv::Vec3b(20, 30, 40));
  EXPECT_EQ(perturb(dotted(), Kind::brightness, 3, 1).at<cv::Vec3b>(42, 80), cv::Vec3b(255, 255, 255));
  EXPECT_EQ(perturb(dotted(), Kind::gamma, 2, 1).at<cv::Vec3b>(0, 0), cv::Vec3b(6, 14, 25));
  const auto grey = perturb(dotted(), Kind::grey, 1, 1).at<cv::Vec3b>(0, 0);
  EXPECT_EQ(grey, cv::Vec3b(64, 64, 64));  // 0.114 * 40 + 0.587 * 60 + 0.299 * 80 = 63.7
}

TEST(Perturbation, NoiseHasItsDeviationAndFollowsTheSeed) {
  const cv::Mat flat(200, 200, CV_8UC3, cv::Scalar(128, 128, 128));
  const cv::Mat noisy = perturb(flat, Kind::noise, 12, 5);
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(noisy, mean, deviation);
  EXPECT_NEAR(mean[0], 128, 0.5);
  EXPECT_NEAR(deviation[0], 12, 0.5);
  EXPECT_EQ(cv::norm(noisy, perturb(flat, Kind::noise, 12, 5), cv::NORM_INF), 0);
  EXPECT_GT(cv::norm(noisy, perturb(flat, Kind::noise, 12, 6), cv::NORM_INF), 0);
}

TEST(Perturbation, BlurKeepsTheMeanAndTakesTheEdges) {
  const cv::Mat blurred = perturb(dotted(), Kind::blur, 0.05, 1);
  EXPECT_NEAR(cv::mean(blurred)[2], cv::mean(dotted())[2], 0.5);
  EXPECT_LT(blurred.at<cv::Vec3b>(42, 80)[2], 130);
}

TEST(Perturbation, OcclusionCoversItsPartOfTheArea) {
  const cv::Mat black = cv::Mat::zeros(100, 100, CV_8UC3);
  cv::Mat covered;
  cv::inRange(perturb(black, Kind::occlusion, 0.25, 3), cv::Scalar(128, 128, 128), cv::Scalar(128, 128, 128),
              covered);
  EXPECT_EQ(cv::countNonZero(covered), 2500);
}

TEST(Perturbation, NeutralStrengthsChangeNothing) {
  for (const auto& [kind, strength] : {std::pair{Kind::shift, 0.0},
                                       {Kind::crop, 0.0},
                                       {Kind::rotate, 0.0},
                                       {Kind::scale, 1.0},
                                       {Kind::brightness, 1.0},
                                       {Kind::gamma, 1.0},
                                       {Kind::noise, 0.0},
                                       {Kind::blur, 0.0},
                                       {Kind::occlusion, 0.0},
                                       {Kind::grey, 0.0}}) {
    EXPECT_EQ(cv::norm(perturb(dotted(), kind, strength, 1), dotted(), cv::NORM_INF), 0) << name(kind);
  }
}

TEST(Perturbation, StrengthsOutOfRangeAreRefused) {
  EXPECT_THROW(perturb(dotted(), Kind::scale, 0, 1), Error);
  EXPECT_THROW(perturb(dotted(), Kind::occlusion, 1.1, 1), Error);
  EXPECT_THROW(perturb(dotted(), Kind::noise, std::nan(""), 1), Error);
  EXPECT_THROW(perturb(cv::Mat(), Kind::grey, 1, 1), Error);
  EXPECT_THROW(perturbation_from_name("fog"), Error);
}

TEST(Perturbation, NamesLeadThereAndBack) {
  for (const std::string_view text : perturbation_names())
    EXPECT_EQ(name(perturbation_from_name(text)), text);
}

}  // namespace
}  // namespace sailmap
