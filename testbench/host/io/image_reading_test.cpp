#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "error_matchers.hpp"
#include "sailmap/image_source.hpp"
#include "sailmap_data.hpp"
#include "temporary_folder.hpp"
#include "test_images.hpp"

namespace sailmap {
namespace {

using testing::alike;
using testing::patterned_image;
using testing::throws_naming;

class ImageReading : public ::testing::Test {
 protected:
  // Written by OpenCV, read by read_image.
  [[nodiscard]] cv::Mat through_file(const std::string& name, const cv::Mat& image,
                                     const std::vector<int>& parameters = {}) const {
    const auto path = folder_.path() / name;
    EXPECT_TRUE(cv::imwrite(path.string(), image, parameters)) << name;
    return read_image(path);
  }

  testing::TemporaryFolder folder_;
};

cv::Mat grey_as_bgr(const cv::Mat& grey) {
  cv::Mat bgr;
  cv::cvtColor(grey, bgr, cv::COLOR_GRAY2BGR);
  return bgr;
}

// 16 bits whose high byte is the image and whose low byte is the same: exactly 257 times the 8-bit sample.
cv::Mat in_16_bits(const cv::Mat& image) {
  cv::Mat wide;
  image.convertTo(wide, CV_16U, 257);
  return wide;
}

TEST_F(ImageReading, ReadsLosslessColourExactly) {
  const cv::Mat image = patterned_image(37, 21, 3);
  for (const char* name : {"a.png", "a.bmp", "a.tif", "a.ppm"})
    EXPECT_TRUE(alike(through_file(name, image), image)) << name;
  EXPECT_TRUE(alike(through_file("a.webp", image, {cv::IMWRITE_WEBP_QUALITY, 101}), image));
}

TEST_F(ImageReading, ReadsGreyAsEqualChannels) {
  const cv::Mat grey = patterned_image(37, 21, 1);
  for (const char* name : {"a.png", "a.bmp", "a.tif", "a.pgm"}) {
    EXPECT_TRUE(alike(through_file(name, grey), grey_as_bgr(grey))) << name;
  }
}

TEST_F(ImageReading, Reduces16BitsTo8) {
  const cv::Mat image = patterned_image(37, 21, 3);
  const cv::Mat grey = patterned_image(37, 21, 1);
  for (const char* name : {"a.png", "a.tif", "a.ppm"}) {
    EXPECT_TRUE(alike(through_file(name, in_16_bits(image)), image)) << name;
  }
  for (const char* name : {"a.png", "a.tif", "a.pgm"}) {
    EXPECT_TRUE(alike(through_file(name, in_16_bits(grey)), grey_as_bgr(grey))) << name;
  }
}

TEST_F(ImageReading, DropsAlpha) {
  const cv::Mat image = patterned_image(37, 21, 4);
  cv::Mat colours;
  cv::cvtColor(image, colours, cv::COLOR_BGRA2BGR);
  EXPECT_TRUE(alike(through_file("a.png", image), colours));
  EXPECT_TRUE(alike(through_file("wide.png", in_16_bits(image)), colours));
}

TEST_F(ImageReading, ReadsBlackAndWhite) {
  cv::Mat bits = patterned_image(37, 21, 1) > 128;
  EXPECT_TRUE(alike(through_file("a.png", bits, {cv::IMWRITE_PNG_BILEVEL, 1}), grey_as_bgr(bits)));
  EXPECT_TRUE(alike(through_file("a.pbm", bits), grey_as_bgr(bits)));
}

TEST_F(ImageReading, ReadsJpegAsOpenCvDoes) {
  for (const int channels : {1, 3}) {
    for (const int progressive : {0, 1}) {
      const auto path = (folder_.path() / "a.jpg").string();
      const std::vector<int> parameters = {cv::IMWRITE_JPEG_PROGRESSIVE, progressive,
                                           cv::IMWRITE_JPEG_RST_INTERVAL, 3};
      ASSERT_TRUE(cv::imwrite(path, patterned_image(75, 50, channels), parameters));
      EXPECT_TRUE(alike(read_image(path), cv::imread(path, cv::IMREAD_COLOR))) << channels << progressive;
    }
  }
}

TEST_F(ImageReading, ReadsRealJpegsAsOpenCvDoes) {
  SAILMAP_NEEDS_DATA("rtabmap_corridor/images");
  SAILMAP_NEEDS_DATA("gardens_point/images");
  for (const char* name : {"rtabmap_corridor/images/0000.jpg", "rtabmap_corridor/images/0083.jpg",
                           "gardens_point/images/0000.jpg", "gardens_point/images/0399.jpg"}) {
    const auto path = testing::data_folder() / name;
    EXPECT_TRUE(alike(read_image(path), cv::imread(path.string()))) << name;
  }
}

TEST_F(ImageReading, ReadsNetpbmTextAndOddMaximumValues) {
  const auto grey = read_image(folder_.file("a.pgm", "P2 # grey\n# 10 bits\n3 1\n1023\n0 1023\n512\n"));
  EXPECT_TRUE(alike(grey, grey_as_bgr((cv::Mat_<unsigned char>(1, 3) << 0, 255, 128))));
  const auto colour = read_image(folder_.file("a.ppm", "P3 1 2 255 1 2 3 4 5 6"));
  EXPECT_TRUE(alike(colour, (cv::Mat_<cv::Vec3b>(2, 1) << cv::Vec3b(3, 2, 1), cv::Vec3b(6, 5, 4))));
  const auto bits = read_image(folder_.file("a.pbm", "P1\n3 2\n101\n0 1 0"));
  EXPECT_TRUE(alike(bits, grey_as_bgr((cv::Mat_<unsigned char>(2, 3) << 0, 255, 0, 255, 0, 255))));
  const auto raw = read_image(folder_.file("b.pgm", std::string("P5 2 1 4095\n\x0F\xFF\x08\x00", 16)));
  EXPECT_TRUE(alike(raw, grey_as_bgr((cv::Mat_<unsigned char>(1, 2) << 255, 128))));
}

TEST_F(ImageReading, GoesByContentNotExtension) {
  const cv::Mat image = patterned_image(16, 16, 3);
  ASSERT_TRUE(cv::imwrite((folder_.path() / "a.png").string(), image));
  std::filesystem::rename(folder_.path() / "a.png", folder_.path() / "a.jpg");
  EXPECT_TRUE(alike(read_image(folder_.path() / "a.jpg"), image));
}

TEST_F(ImageReading, NamesTheFileAndTheFault) {
  const auto missing = folder_.path() / "missing.png";
  EXPECT_THAT([&] { read_image(missing); }, throws_naming(missing, "no such file"));
  EXPECT_THAT([&] { read_image(folder_.path()); }, throws_naming(folder_.path(), "a folder"));
  const auto empty = folder_.file("empty.png", "");
  EXPECT_THAT([&] { read_image(empty); }, throws_naming(empty, "empty file"));
  const auto text = folder_.file("text.jpg", "this is no image, whatever its name says\n");
  EXPECT_THAT([&] { read_image(text); }, throws_naming(text, "not an image"));
}

TEST_F(ImageReading, RefusesImpossibleSizes) {
  const auto huge = folder_.file("huge.ppm", "P6 16000000 16000000 255\n...");
  EXPECT_THAT([&] { read_image(huge); }, throws_naming(huge, "image size 16000000 x 16000000"));
  const auto none = folder_.file("none.pgm", "P5 0 5 255\n");
  EXPECT_THAT([&] { read_image(none); }, throws_naming(none, "image size 0 x 5"));
}

TEST(ImageView, ShowsThePixelsOfAMat) {
  const cv::Mat whole = patterned_image(20, 10, 3);
  const cv::Mat part = whole(cv::Rect(3, 2, 8, 5));
  const ImageView view = view_of(part);
  EXPECT_EQ(view.width, 8);
  EXPECT_EQ(view.height, 5);
  const auto bgr = whole.at<cv::Vec3b>(2 + 4, 3 + 6);
  const auto seen = view.at(6, 4);
  EXPECT_THAT((std::array{seen.b, seen.g, seen.r}), ::testing::ElementsAre(bgr[0], bgr[1], bgr[2]));
  EXPECT_THROW(view_of(cv::Mat(4, 4, CV_8UC1)), Error);
}

}  // namespace
}  // namespace sailmap
