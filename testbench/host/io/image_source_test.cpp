#include "sailmap/image_source.hpp"

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <string>
#include <vector>

#include "error_matchers.hpp"
#include "io/video_source.hpp"
#include "sailmap/error.hpp"
#include "temporary_folder.hpp"
#include "test_images.hpp"

namespace sailmap {
namespace {

using testing::throws_naming;
using ::testing::internal::CaptureStderr;
using ::testing::internal::GetCapturedStderr;

// Every test here also demands that nothing is printed.
class Source : public ::testing::Test {
 protected:
  void SetUp() override { CaptureStderr(); }
  void TearDown() override { EXPECT_EQ(GetCapturedStderr(), ""); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  testing::TemporaryFolder folder_;
};

std::vector<Frame> all_frames(ImageSource& source) {
  std::vector<Frame> frames;
  while (auto frame = source.next()) frames.push_back(*frame);
  return frames;
}

TEST_F(Source, FolderGivesItsImagesInOrder) {
  const cv::Mat first = testing::patterned_image(20, 10, 3);
  const cv::Mat second = 255 - first;
  ASSERT_TRUE(cv::imwrite(path("2.png"), first));
  ASSERT_TRUE(cv::imwrite(path("10.png"), second));
  const auto source = open_source(folder_.path().string());
  EXPECT_EQ(source->size(), 2);
  const auto frames = all_frames(*source);
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].name, path("2.png"));
  EXPECT_EQ(frames[1].name, path("10.png"));
  EXPECT_TRUE(testing::alike(frames[0].image, first));
  EXPECT_TRUE(testing::alike(frames[1].image, second));
  EXPECT_FALSE(source->next().has_value());
}

TEST_F(Source, GivesTheImagesBeforeABrokenOne) {
  ASSERT_TRUE(cv::imwrite(path("1.png"), testing::patterned_image(20, 10, 3)));
  const auto broken = folder_.file("2.png", "nonsense");
  const auto source = open_source(path("*.png"));
  EXPECT_TRUE(source->next().has_value());
  EXPECT_THAT([&] { source->next(); }, throws_naming(broken, "not an image"));
}

TEST_F(Source, ListedImagesCanBeOpenedAgain) {
  ASSERT_TRUE(cv::imwrite(path("1.png"), testing::patterned_image(20, 10, 3)));
  const auto source = open_images(list_images(path("1.png")));
  EXPECT_EQ(source->size(), 1);
  EXPECT_EQ(all_frames(*source).size(), 1U);
}

class VideoSource : public Source {
 protected:
  // Frame i has the grey level 10 i throughout. Motion JPEG: every frame stands alone.
  void SetUp() override {
    Source::SetUp();
    cv::VideoWriter writer(video_, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 10, {160, 120});
    for (int i = 0; i < frames_; ++i) writer.write(cv::Mat(120, 160, CV_8UC3, cv::Scalar::all(10 * i)));
  }

  const int frames_ = 20;
  const std::string video_ = path("drive.avi");
};

TEST_F(VideoSource, GivesItsFramesByNumber) {
  const auto source = open_source(video_);
  EXPECT_EQ(source->size(), std::nullopt);
  const auto frames = all_frames(*source);
  ASSERT_EQ(frames.size(), 20U);
  for (int i = 0; i < frames_; ++i) {
    const Frame& frame = frames[static_cast<std::size_t>(i)];
    EXPECT_EQ(frame.name, video_ + "#" + std::to_string(i));
    EXPECT_TRUE(testing::alike(frame.image, cv::Mat(120, 160, CV_8UC3, cv::Scalar::all(10 * i)), 3)) << i;
  }
  EXPECT_FALSE(source->next().has_value());
  EXPECT_EQ(source->early_end(), std::nullopt);
}

TEST_F(VideoSource, CutShortEndsEarly) {
  const std::string whole = testing::content_of(video_);
  const auto cut = folder_.file("cut.avi", std::string_view(whole).substr(0, whole.size() * 55 / 100));
  const auto source = open_source(cut.string());
  const auto frames = all_frames(*source);
  EXPECT_GT(frames.size(), 2U);
  EXPECT_LT(frames.size(), 20U);
  EXPECT_FALSE(source->next().has_value());
  EXPECT_EQ(source->early_end(),
            cut.string() + ": ends after " + std::to_string(frames.size()) + " frames, its header says 20");
}

TEST_F(VideoSource, ACameraThatGivesNoMoreIsAnError) {
  const auto source = io::camera("camera 3", cv::VideoCapture(video_, cv::CAP_FFMPEG));
  for (int i = 0; i < frames_; ++i) {
    const auto frame = source->next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->name, "camera 3#" + std::to_string(i));
    EXPECT_TRUE(frame->time);
  }
  EXPECT_THAT([&] { source->next(); },
              ::testing::ThrowsMessage<Error>("camera 3: gives no more images after 20"));
}

TEST_F(VideoSource, CutInItsHeaderIsAnError) {
  const std::string whole = testing::content_of(video_);
  const auto cut = folder_.file("cut.avi", std::string_view(whole).substr(0, 150));
  EXPECT_THAT([&] { open_source(cut.string()); }, throws_naming(cut, "nor a video that can be read"));
}

TEST_F(Source, FileThatIsNoVideoIsAnError) {
  const auto text = folder_.file("notes.avi", "this is no video\n");
  EXPECT_THAT([&] { open_source(text.string()); }, throws_naming(text, "nor a video"));
  const auto empty = folder_.file("empty.mp4", "");
  EXPECT_THAT([&] { open_source(empty.string()); }, throws_naming(empty, "nor a video"));
  const auto number = folder_.file("frame001.dat", std::string(5000, '\x55'));
  EXPECT_THAT([&] { open_source(number.string()); }, throws_naming(number, "nor a video"));
}

TEST_F(Source, MissingSourceIsAnError) {
  EXPECT_THAT([&] { open_source(path("drive.mp4")); }, throws_naming(path("drive.mp4"), "no such folder"));
  EXPECT_THAT([&] { open_source(path("a.png")); }, throws_naming(path("a.png"), "no such file"));
  EXPECT_THAT([] { open_source("-1"); }, throws_naming("-1", "no such"));
  EXPECT_THAT([] { open_source(""); }, ::testing::Throws<Error>());
  EXPECT_THAT([] { open_source("99999999999999999999"); }, throws_naming("99999999999999999999", "no such"));
}

TEST_F(Source, MissingCameraIsAnError) {
  EXPECT_THAT([] { open_source("97"); }, throws_naming("camera 97", "no such camera"));
}

}  // namespace
}  // namespace sailmap
