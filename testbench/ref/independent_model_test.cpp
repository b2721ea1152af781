// The whole reference, spec sections 2-7, against the independent model in Python: every map within 1e-9 of
// its maximum, every number of local maxima equal.
#include "independent_model.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "needs.hpp"
#include "planes.hpp"
#include "sailmap/ref/model.hpp"
#include "sailmap_data.hpp"

namespace sailmap {
namespace {

namespace fs = std::filesystem;
using testing::Image;
using testing::IndependentModel;
using testing::Rgb;

constexpr std::array feature_names = {"intensity_on", "intensity_off", "green",  "blue",   "red",
                                      "yellow",       "ori_0",         "ori_45", "ori_90", "ori_135"};
constexpr std::array conspicuity_names = {"conspicuity_intensity", "conspicuity_colour",
                                          "conspicuity_orientation"};

class IndependentModelTest : public ::testing::Test {
 protected:
  void SetUp() override {
    SAILMAP_NEEDS_TOOL(testing::has_independent_model(), "Python with numpy, scipy and cv2");
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / (std::string("sailmap_") + test->name() + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override {
    if (!folder_.empty()) fs::remove_all(folder_);
  }

  // `tolerance`: of each map's maximum.
  void expect_equal(const fs::path& image, double tolerance = 1e-9) {
    const cv::Mat bgr = cv::imread(image.string(), cv::IMREAD_COLOR);
    ASSERT_FALSE(bgr.empty()) << image;
    const ref::Model model = ref::compute<ref::Exact>(
        {bgr.cols, bgr.rows, bgr.data, static_cast<std::ptrdiff_t>(bgr.step), ChannelOrder::bgr});
    const IndependentModel expected = testing::run_independent_model(image, folder_ / "maps");
    for (std::size_t i = 0; i < feature_names.size(); ++i) {
      expect_equal(model.features[i], feature_names.at(i), expected, tolerance);
      EXPECT_EQ(model.feature_statistics[i].maxima, expected.maxima.at(feature_names.at(i)))
          << feature_names.at(i);
    }
    for (std::size_t i = 0; i < conspicuity_names.size(); ++i) {
      expect_equal(model.conspicuities[i], conspicuity_names.at(i), expected, tolerance);
      EXPECT_EQ(model.conspicuity_statistics[i].maxima, expected.maxima.at(conspicuity_names.at(i)));
    }
    expect_equal(model.saliency, "saliency", expected, tolerance);
  }

  void expect_equal(const Image& image, double tolerance = 1e-9) {
    cv::Mat bgr;
    cv::cvtColor(image.rgb(), bgr, cv::COLOR_RGB2BGR);
    const fs::path path = folder_ / "image.png";
    ASSERT_TRUE(cv::imwrite(path.string(), bgr));
    expect_equal(path, tolerance);
  }

 private:
  static void expect_equal(const Plane<double>& map, const std::string& name,
                           const IndependentModel& expected, double tolerance) {
    const cv::Mat& reference = expected.maps.at(name);
    double maximum = 0;
    cv::minMaxLoc(reference, nullptr, &maximum);
    EXPECT_LE(testing::largest_difference(map, reference), tolerance * maximum) << name;
  }

  fs::path folder_;
};

TEST_F(IndependentModelTest, AgreesOnThePhotographOfACorridor) {
  SAILMAP_NEEDS_DATA("rtabmap_corridor/images/0020.jpg");
  expect_equal(testing::data_folder() / "rtabmap_corridor/images/0020.jpg");
}

// Its C_I has a peak of half its maximum, exactly: the intensity maps have 9 and 36 maxima.
TEST_F(IndependentModelTest, AgreesOnAPeakOfHalfTheMaximum) {
  SAILMAP_NEEDS_DATA("rtabmap_corridor/images/0012.jpg");
  expect_equal(testing::data_folder() / "rtabmap_corridor/images/0012.jpg");
}

TEST_F(IndependentModelTest, AgreesOnThePhotographOfAGarden) {
  SAILMAP_NEEDS_DATA("gardens_point/images/0077.jpg");
  expect_equal(testing::data_folder() / "gardens_point/images/0077.jpg");
}

TEST_F(IndependentModelTest, AgreesOnNoise64x64) { expect_equal(Image::noise(64, 64, 1)); }
TEST_F(IndependentModelTest, AgreesOnNoise65x97) { expect_equal(Image::noise(65, 97, 2)); }
TEST_F(IndependentModelTest, AgreesOnNoise101x67) { expect_equal(Image::noise(101, 67, 3)); }
TEST_F(IndependentModelTest, AgreesOnNoise127x64) { expect_equal(Image::noise(127, 64, 4)); }

TEST_F(IndependentModelTest, AgreesOnACheckerboard) {
  expect_equal(Image::painted(128, 96, [](int x, int y) {
    return (x / 32 + y / 32) % 2 == 0 ? Rgb{255, 255, 0} : Rgb{0, 0, 255};
  }));
}

TEST_F(IndependentModelTest, AgreesOnStripes) {
  expect_equal(Image::painted(128, 96, [](int x, int) {
    return x / 16 % 2 == 0 ? Rgb{0, 0, 0} : Rgb{255, 255, 255};
  }));
}

TEST_F(IndependentModelTest, AgreesThatOneHueHasNoColourContrast) {
  expect_equal(Image::painted(128, 96, [](int x, int y) {
    const int light = 20 + (x * x + 3 * y) % 40;
    return Rgb{4 * light, 2 * light, light};
  }));
}

// The weakest image there is: its maps reach 1e-6 or so, where the grid of 2^-40 shows.
TEST_F(IndependentModelTest, AgreesRoughlyOnASingleGreyLevel) {
  Image image(128, 96, {90, 90, 90});
  image.set(60, 40, {91, 90, 90});
  expect_equal(image, 1e-5);
}

TEST_F(IndependentModelTest, AgreesThatAFlatImageIsZero) { expect_equal(Image(64, 80, {7, 201, 93})); }

}  // namespace
}  // namespace sailmap
