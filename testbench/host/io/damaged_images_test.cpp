// Images that were cut short or damaged on their way: an Error that names the file, and not a word on stderr.
#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>
#include <random>
#include <string>

#include "error_matchers.hpp"
#include "sailmap/image_source.hpp"
#include "temporary_folder.hpp"
#include "test_images.hpp"

namespace sailmap {
namespace {

using testing::patterned_image;
using ::testing::internal::CaptureStderr;
using ::testing::internal::GetCapturedStderr;

class DamagedImage : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { CaptureStderr(); }
  void TearDown() override { EXPECT_EQ(GetCapturedStderr(), ""); }

  // The bytes of a small image in the format of the test.
  [[nodiscard]] static std::string encoded(const std::vector<int>& parameters = {}) {
    std::vector<unsigned char> bytes;
    EXPECT_TRUE(cv::imencode(GetParam(), patterned_image(40, 30, 3), bytes, parameters));
    return {bytes.begin(), bytes.end()};
  }
  [[nodiscard]] std::filesystem::path file(std::string_view content) const {
    return folder_.file(std::string("image") + GetParam(), content);
  }

  testing::TemporaryFolder folder_;
};

TEST_P(DamagedImage, CutAnywhereIsAnError) {
  const std::string whole = encoded();
  EXPECT_FALSE(read_image(file(whole)).empty());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto path = file(std::string_view(whole).substr(0, size));
    EXPECT_THAT([&] { read_image(path); }, testing::throws_naming(path, ""))
        << size << " of " << whole.size();
  }
}

TEST_P(DamagedImage, CutInTheMiddleIsCalledTruncated) {
  const std::string whole = encoded();
  const auto path = file(std::string_view(whole).substr(0, whole.size() / 2));
  EXPECT_THAT([&] { read_image(path); }, testing::throws_naming(path, "truncated"));
}

TEST_P(DamagedImage, BytesAfterTheImageDoNotMatter) {
  const cv::Mat image = read_image(file(encoded()));
  EXPECT_TRUE(testing::alike(read_image(file(encoded() + std::string(300, 'x'))), image));
}

// True when the file is an image; false when reading it throws the Error that names it.
bool reads_as_image(const std::filesystem::path& path) {
  try {
    EXPECT_EQ(read_image(path).type(), CV_8UC3);
    return true;
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::StartsWith(path.string() + ": "));
    return false;
  }
}

// Whatever the bytes: an image or an Error, never a crash and never a word. Every second trial hits the
// header.
TEST_P(DamagedImage, FlippedBytesGiveAnImageOrAnError) {
  std::mt19937 random(3);
  const std::string whole = encoded();
  int errors = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const std::size_t reach = trial % 2 == 0 ? 64 : whole.size();
    std::string damaged = whole;
    for (int i = 0; i < 3; ++i) damaged[random() % reach] = static_cast<char>(random());
    errors += reads_as_image(file(damaged)) ? 0 : 1;
  }
  EXPECT_GT(errors, 40);
}

INSTANTIATE_TEST_SUITE_P(Formats, DamagedImage,
                         ::testing::Values(".jpg", ".png", ".bmp", ".tif", ".webp", ".ppm"),
                         [](const auto& format) { return std::string(format.param + 1); });

class DamagedJpeg : public DamagedImage {};

TEST_P(DamagedJpeg, ProgressiveCutAnywhereIsAnError) {
  const std::string whole = encoded({cv::IMWRITE_JPEG_PROGRESSIVE, 1});
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto path = file(std::string_view(whole).substr(0, size));
    EXPECT_THAT([&] { read_image(path); }, testing::throws_naming(path, "")) << size;
  }
}

// A file half copied into a preallocated one: the size is right and the end is zeros.
TEST_P(DamagedJpeg, ZeroedEndIsAnError) {
  std::string bytes = encoded();
  std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() / 2), bytes.end(), '\0');
  const auto path = file(bytes);
  EXPECT_THAT([&] { read_image(path); }, testing::throws_naming(path, "JPEG"));
}

// Many cameras write a stray byte or two before the end marker; every pixel is there.
TEST_P(DamagedJpeg, StrayBytesBeforeTheEndMarkerDoNotMatter) {
  std::string bytes = encoded();
  const cv::Mat image = read_image(file(bytes));
  bytes.insert(bytes.size() - 2, std::string("\x12\x34", 2));
  EXPECT_TRUE(testing::alike(read_image(file(bytes)), image));
}

INSTANTIATE_TEST_SUITE_P(Formats, DamagedJpeg, ::testing::Values(".jpg"));

}  // namespace
}  // namespace sailmap
