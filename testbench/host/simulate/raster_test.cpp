// The renderer against OpenCV's projection and perspective warp, which share no code with it.
#include "simulate/raster.hpp"

#include <gtest/gtest.h>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace sailmap::simulate {
namespace {

constexpr int width = 400;
constexpr int height = 300;
const Haze no_haze{{0, 0, 0}, 1e9F};

View make_view() {
  View view;
  view.position = {2, -1, 1.5};
  view.world_to_camera = View::rotation(0.3, 0.1, 0.05);
  view.focal = 300;
  view.centre_x = width / 2.0;
  view.centre_y = height / 2.0;
  return view;
}

// A smooth picture: small differences of sampling stay small differences of colour.
cv::Mat4b smooth_picture() {
  cv::Mat4b picture(64, 96);
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x)
      picture(y, x) = cv::Vec4b(static_cast<uchar>(40 + 2 * x), static_cast<uchar>(40 + 3 * y),
                                static_cast<uchar>(60 + x + y), 255);
  return picture;
}

cv::Mat4b plain(const cv::Vec3b& c) { return cv::Mat4b(4, 4, cv::Vec4b(c[0], c[1], c[2], 255)); }

// Pixels in continuous coordinates: the centre of the first pixel is at (0.5, 0.5).
std::vector<cv::Point2d> project(const View& view, const std::vector<cv::Point3d>& points) {
  cv::Vec3d rotation;
  cv::Rodrigues(view.world_to_camera, rotation);
  const cv::Vec3d translation = -(view.world_to_camera * view.position);
  const cv::Matx33d camera(view.focal, 0, view.centre_x, 0, view.focal, view.centre_y, 0, 0, 1);
  std::vector<cv::Point2d> pixels;
  cv::projectPoints(points, rotation, translation, camera, cv::noArray(), pixels);
  return pixels;
}

TEST(Raster, PutsAPictureWhereOpenCvPutsIt) {
  const View view = make_view();
  const cv::Vec3d origin(8, 1, 0.2);
  const cv::Vec3d right(2, -3, 0.3);
  const cv::Vec3d up(0.2, 0, 2.5);
  const cv::Mat4b picture = smooth_picture();
  Raster raster(width, height, view, no_haze);
  raster.paint_solid({make_panel(origin, right, up, make_texture(picture))});

  const std::vector<cv::Point2d> corners =
      project(view, {origin + up, origin + right + up, origin + right, origin});  // upper left first
  const std::vector<cv::Point2f> target(corners.begin(), corners.end());
  const auto w = static_cast<float>(picture.cols);
  const auto h = static_cast<float>(picture.rows);
  const std::vector<cv::Point2f> source = {{0, 0}, {w, 0}, {w, h}, {0, h}};
  cv::Mat transform = cv::getPerspectiveTransform(source, target);
  // OpenCV counts from the centre of the first pixel.
  const cv::Matx33d half(1, 0, 0.5, 0, 1, 0.5, 0, 0, 1);
  transform = cv::Mat(half.inv()) * transform * cv::Mat(half);
  cv::Mat expected;
  cv::Mat bgr;
  cv::cvtColor(picture, bgr, cv::COLOR_BGRA2BGR);
  cv::warpPerspective(bgr, expected, transform, {width, height}, cv::INTER_LINEAR);

  cv::Mat inside;
  cv::inRange(expected, cv::Scalar(36, 36, 56), cv::Scalar(255, 255, 255), inside);
  cv::Mat safe;
  cv::erode(inside, safe, cv::Mat::ones(5, 5, CV_8U));
  ASSERT_GT(cv::countNonZero(safe), 3000);
  cv::Mat difference;
  cv::absdiff(raster.colour(), expected, difference);
  double most = 0;
  cv::Mat within;
  difference.copyTo(within, safe);
  cv::minMaxLoc(within.reshape(1), nullptr, &most);
  // Texels are up to 3 grey levels apart and positions are rounded to a sixteenth of a texel, in smaller
  // levels too.
  EXPECT_LE(most, 6);
  // Its outline, to a pixel: nothing painted away from the panel.
  cv::Mat wide;
  cv::dilate(inside, wide, cv::Mat::ones(3, 3, CV_8U));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (wide.at<uchar>(y, x) == 0) {
        ASSERT_EQ(raster.colour()(y, x), cv::Vec3b(0, 0, 0)) << x << ',' << y;
      }
}

TEST(Raster, DepthIsTheDistanceAlongTheOpticalAxis) {
  const View view = make_view();
  const cv::Vec3d origin(9, -3, 0);
  Raster raster(width, height, view, no_haze);
  raster.paint_solid({make_panel(origin, {1, 5, 0}, {0, 0, 4}, make_texture(plain({9, 9, 9})))});
  for (const double u : {0.2, 0.5, 0.8}) {
    const cv::Point3d point(origin[0] + u, origin[1] + 5 * u, 2);
    const cv::Point2d pixel = project(view, {point}).front();
    const cv::Vec3d seen = view.world_to_camera * (cv::Vec3d(point) - view.position);
    EXPECT_NEAR(raster.depth()(static_cast<int>(pixel.y), static_cast<int>(pixel.x)), seen[2], 0.02);
  }
}

TEST(Raster, NearThingsHideFarOnesInWhateverOrder) {
  const View view = make_view();
  const Surface near = make_panel({6, -1, 0}, {0, 3, 0}, {0, 0, 3}, make_texture(plain({0, 0, 255})));
  const Surface far = make_panel({12, -3, 0}, {0, 9, 0}, {0, 0, 5}, make_texture(plain({255, 0, 0})));
  Raster one(width, height, view, no_haze);
  one.paint_solid({near, far});
  Raster other(width, height, view, no_haze);
  other.paint_solid({far, near});
  const cv::Point2d pixel = project(view, {{6, 0.5, 1.5}}).front();
  EXPECT_EQ(one.colour()(static_cast<int>(pixel.y), static_cast<int>(pixel.x)), cv::Vec3b(0, 0, 255));
  EXPECT_EQ(cv::norm(one.colour(), other.colour(), cv::NORM_INF), 0);
  // Painted later as a blended surface, the far one stays behind.
  Raster third(width, height, view, no_haze);
  third.paint_solid({near});
  third.paint_blended({far});
  EXPECT_EQ(cv::norm(one.colour(), third.colour(), cv::NORM_INF), 0);
}

TEST(Raster, BlendsByAlphaAndPaintsCoplanarShadowsOnce) {
  const View view = make_view();
  const Surface wall = make_panel({10, -4, 0}, {0, 9, 0}, {0, 0, 5}, make_texture(plain({200, 200, 200})));
  Surface shadow = make_panel({9.5, -2, 0}, {0, 5, 0}, {0, 0, 3}, make_texture(plain({0, 0, 0})));
  shadow.opacity = 0.5F;
  Raster raster(width, height, view, no_haze);
  raster.paint_solid({wall});
  raster.paint_blended({shadow, shadow});
  const cv::Point2d pixel = project(view, {{9.5, 0.5, 1.5}}).front();
  EXPECT_NEAR(raster.colour()(static_cast<int>(pixel.y), static_cast<int>(pixel.x))[0], 100, 1);
}

TEST(Raster, CutsAtTheCamera) {
  // A floor that reaches far behind the camera fills the picture below the horizon and nothing above it.
  View view = make_view();
  view.world_to_camera = View::rotation(0, 0, 0);
  Raster raster(width, height, view, no_haze);
  raster.paint_solid(
      {make_panel({-500, 500, 0}, {0, -1000, 0}, {1500, 0, 0}, make_texture(plain({7, 8, 9})))});
  for (int x = 0; x < width; x += 37) {
    EXPECT_EQ(raster.colour()(height - 1, x), cv::Vec3b(7, 8, 9));
    EXPECT_EQ(raster.colour()(height / 2 + 3, x), cv::Vec3b(7, 8, 9));
    EXPECT_EQ(raster.colour()(height / 2 - 1, x), cv::Vec3b(0, 0, 0));
  }
}

}  // namespace
}  // namespace sailmap::simulate
