// Text and image writing.
#include "figures/drawing.hpp"

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>

#include "figure_fixture.hpp"
#include "sailmap/error.hpp"
#include "sailmap/figures.hpp"

namespace sailmap {
namespace {

using drawing::Text;
using testing::count_colour;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const cv::Vec3b white(255, 255, 255);

cv::Mat paper() { return {60, 400, CV_8UC3, drawing::white}; }

// The box round all that is not white.
cv::Rect inked(const cv::Mat& image) {
  cv::Mat grey;
  cv::Mat mask(image.size(), CV_8UC1);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x)
      mask.at<std::uint8_t>(y, x) = image.at<cv::Vec3b>(y, x) != white ? 255 : 0;
  }
  int left = image.cols;
  int right = -1;
  int top = image.rows;
  int bottom = -1;
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      if (mask.at<std::uint8_t>(y, x) == 0) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  }
  return {left, top, right - left + 1, bottom - top + 1};
}

// With the system's font and with OpenCV's own.
class TextTest : public ::testing::TestWithParam<bool> {
 protected:
  Text text_ = GetParam() ? Text() : Text("");
};
INSTANTIATE_TEST_SUITE_P(Fonts, TextTest, ::testing::Bool(),
                         [](const auto& fonts) { return fonts.param ? "system" : "stroke"; });

TEST_P(TextTest, StandsOnItsBaselineAndIsAsWideAsItSays) {
  for (const int size : {12, 16, 24}) {
    cv::Mat canvas = paper();
    text_.draw(canvas, "HIM", {10, 40}, size, drawing::black);
    const cv::Rect box = inked(canvas);
    EXPECT_NEAR(box.br().y, 40, 2) << size;
    EXPECT_NEAR(box.height, 0.73 * size, 2.5) << size;  // height of capitals
    EXPECT_NEAR(box.x, 10, 3) << size;
    EXPECT_NEAR(box.width, text_.width("HIM", size), 5) << size;
  }
}

TEST_P(TextTest, BeyondTheCanvasIsNotDrawn) {
  cv::Mat canvas = paper();
  text_.draw(canvas, "half outside", {360, 30}, 20, drawing::black);
  text_.draw(canvas, "far away", {5000, 5000}, 20, drawing::black);
  text_.draw(canvas, "above", {10, -100}, 20, drawing::black);
  text_.draw(canvas, "", {10, 30}, 20, drawing::black);
  EXPECT_GE(inked(canvas).x, 355);
}

TEST_P(TextTest, LinesAreNoWiderThanAllowedAndLoseNoWord) {
  const std::string words = "the quick brown fox jumps over the lazy dog and then some more words follow it";
  const std::vector<std::string> lines = text_.wrapped(words, 16, 200);
  EXPECT_GT(lines.size(), 2U);
  std::string joined;
  for (const std::string& line : lines) {
    EXPECT_LE(text_.width(line, 16), 200);
    joined += (joined.empty() ? "" : " ") + line;
  }
  EXPECT_EQ(joined, words);
  EXPECT_THAT(text_.wrapped("  two   words ", 16, 1000), ElementsAre("two words"));
  EXPECT_TRUE(text_.wrapped("", 16, 100).empty());
}

TEST_P(TextTest, AWordWiderThanALineIsBroken) {
  const std::string word = "/a/very/long/path/without/any/space/in/it/at/all/image_000123.jpg";
  const std::vector<std::string> lines = text_.wrapped("see " + word + " there", 16, 150);
  std::string joined;
  for (const std::string& line : lines) {
    EXPECT_LE(text_.width(line, 16), 150);
    joined += line;
  }
  EXPECT_THAT(joined, HasSubstr(word));
  EXPECT_EQ(lines.front(), "see");
  // Not even one letter fits: still one letter a line, rather than none for ever.
  EXPECT_THAT(text_.wrapped("\xC3\xA9t", 16, 1), ElementsAre("\xC3\xA9", "t"));
}

TEST_P(TextTest, TooLongCaptionsLoseTheirMiddle) {
  cv::Mat canvas = paper();
  text_.draw_within(canvas, "a caption that is far too long to be drawn in this place", {10, 30}, 16,
                    drawing::black, 150);
  EXPECT_LE(inked(canvas).br().x, 10 + 150 + 3);
  EXPECT_GT(inked(canvas).width, 110);
}

TEST(Text, SystemFontKnowsLettersBeyondAscii) {
  ASSERT_FALSE(drawing::font_file().empty());
  const Text text;
  EXPECT_LT(text.width("\xC3\xA9\xC3\xA9\xC3\xA9", 20), text.width("eeeeee", 20));
  // The stroke font has none: one question mark a letter.
  EXPECT_EQ(Text("").width("\xC3\xA9", 20), Text("").width("?", 20));
}

TEST(Text, OnlyPrintableTextIsLeft) {
  EXPECT_EQ(drawing::printable("a\tb\nc\x01\x7F"), "a b c  ");
  EXPECT_EQ(drawing::printable("caf\xC3\xA9"), "caf\xC3\xA9");
  EXPECT_EQ(drawing::printable("bad\xFF byte"), "bad byte");
}

TEST(Drawing, ImagesKeepTheirShape) {
  EXPECT_EQ(drawing::fit({640, 480}, {320, 1000}), cv::Size(320, 240));
  EXPECT_EQ(drawing::fit({64, 64}, {300, 200}), cv::Size(200, 200));
  EXPECT_EQ(drawing::fit({4096, 64}, {32, 32}), cv::Size(32, 1));
}

TEST(Drawing, ColoursOfMatchesDiffer) {
  for (int a = 0; a < 20; ++a) {
    for (int b = a + 1; b < 20; ++b) {
      EXPECT_GT(cv::norm(drawing::distinct_colour(a) - drawing::distinct_colour(b)), 15) << a << ' ' << b;
    }
  }
}

class WriteImageTest : public testing::FigureTest {};

TEST_F(WriteImageTest, PixelsSurvive) {
  const cv::Mat image = testing::picture(80, 60);
  for (const char* name : {"a.png", "a.bmp", "a.PNG", "a.tiff"}) {
    write_image(folder_ / name, image);
    EXPECT_EQ(cv::norm(cv::imread((folder_ / name).string()), image, cv::NORM_INF), 0) << name;
  }
  write_image(folder_ / "a.jpg", image);
  EXPECT_EQ(cv::imread((folder_ / "a.jpg").string()).size(), image.size());
}

TEST_F(WriteImageTest, NothingIsLeftWhenItFails) {
  const cv::Mat image = testing::picture(80, 60);
  const auto write = [&](const std::string& name, const cv::Mat& pixels) {
    return [=, this] { write_image(folder_ / name, pixels); };
  };
  EXPECT_THAT(write("a.xyz", image), ThrowsMessage<Error>(HasSubstr("a.xyz: no image format")));
  EXPECT_THAT(write("none", image), ThrowsMessage<Error>(HasSubstr("none")));
  EXPECT_THAT(write("missing/a.png", image), ThrowsMessage<Error>(HasSubstr("missing/a.png")));
  EXPECT_THAT(write("a.png", {}), ThrowsMessage<Error>(HasSubstr("a.png")));
  EXPECT_EQ(files(), 0);
}

}  // namespace
}  // namespace sailmap
