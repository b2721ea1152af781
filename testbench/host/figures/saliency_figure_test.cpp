// The saliency figure: panels hold what they say, boxes are where the regions are, nothing overlaps.
#include <gmock/gmock.h>

#include <cmath>

#include "figure_fixture.hpp"
#include "figures/drawing.hpp"
#include "figures/saliency_layout.hpp"
#include "sailmap/error.hpp"
#include "sailmap/figures.hpp"

namespace sailmap {
namespace {

using testing::colour_at;
using testing::count_colour;
using testing::Described;
using testing::described;
using ::testing::HasSubstr;
using testing::picture;
using ::testing::ThrowsMessage;

const cv::Vec3b region_colour(0, 230, 255);
const cv::Vec3b white(255, 255, 255);

// Bilinear interpolation of sample centres, edges replicated.
double between(const Plane<double>& map, double x, double y) {
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(std::floor(y));
  const double fx = x - x0;
  const double fy = y - y0;
  return (1 - fy) * ((1 - fx) * map.clamped(x0, y0) + fx * map.clamped(x0 + 1, y0)) +
         fy * ((1 - fx) * map.clamped(x0, y0 + 1) + fx * map.clamped(x0 + 1, y0 + 1));
}

// The panel shows the map, 0 black and its maximum white, enlarged. Grey levels of the samples are rounded
// first, so that a pixel may be off by one.
void expect_panel_shows(const cv::Mat& figure, const cv::Rect& place, const Map& map) {
  const Plane<double> values = map.values();
  double maximum = 0;
  for (const double v : values.samples()) maximum = std::max(maximum, v);
  ASSERT_GT(maximum, 0);
  ASSERT_GT(place.width, values.width());
  double worst = 0;
  for (int y = 0; y < place.height; ++y) {
    for (int x = 0; x < place.width; ++x) {
      const double expected = 255 / maximum *
                              between(values, (x + 0.5) * values.width() / place.width - 0.5,
                                      (y + 0.5) * values.height() / place.height - 0.5);
      const cv::Vec3b pixel = colour_at(figure, place.x + x, place.y + y);
      for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(pixel[c] - expected));
    }
  }
  EXPECT_LT(worst, 1.6);
}

Plane<double> noise(int width, int height, unsigned seed, double top) {
  Plane<double> out(width, height);
  std::mt19937 random(seed);
  for (double& v : out.samples()) v = top * static_cast<double>(random() % 1000) / 999;
  return out;
}

// Maps that no front end would make, so that each panel can only show its own.
Described made_up(int width, int height) {
  Described d;
  d.image = picture(width, height);
  d.maps.image_width = width;
  d.maps.image_height = height;
  d.signature = {width, height, {}};
  const int w = hls::geometry::base_side(width);
  const int h = hls::geometry::base_side(height);
  unsigned seed = 10;
  for (Map& map : d.maps.features) {
    ++seed;
    map.samples = noise(w, h, seed, seed);
  }
  for (Map& map : d.maps.conspicuities) map.samples = noise(w, h, ++seed, 0.5);
  Plane<std::uint16_t> raw(w, h);
  std::mt19937 random(99);
  for (auto& v : raw.samples()) v = static_cast<std::uint16_t>(random() % 60000);
  d.maps.saliency.samples = raw;
  d.maps.saliency.lsb = 1.0 / 4096;
  return d;
}

TEST(SaliencyFigure, EachPanelShowsItsOwnMapScaledToItsMaximum) {
  const Described d = made_up(320, 240);
  const cv::Mat figure = saliency_figure(d.image, d.maps, d.signature, 10, "title");
  const SaliencyLayout layout = lay_out_saliency({320, 240}, 1);
  ASSERT_EQ(figure.size(), layout.canvas);
  EXPECT_EQ(figure.type(), CV_8UC3);
  for (std::size_t i = 0; i < feature_count; ++i) {
    SCOPED_TRACE(feature_names[i]);
    expect_panel_shows(figure, layout.features[i], d.maps.features[i]);
  }
  for (std::size_t k = 0; k < conspicuity_count; ++k) {
    SCOPED_TRACE(conspicuity_names[k]);
    expect_panel_shows(figure, layout.conspicuities[k], d.maps.conspicuities[k]);
  }
  expect_panel_shows(figure, layout.saliency, d.maps.saliency);
  EXPECT_NEAR(figure.cols, 1600, 5);
}

TEST(SaliencyFigure, AFlatMapIsBlack) {
  Described d = made_up(128, 128);
  d.maps.features[3].samples = Plane<double>(32, 32, 0);
  const cv::Mat figure = saliency_figure(d.image, d.maps, d.signature, 10, "");
  const cv::Rect place = lay_out_saliency({128, 128}, 0).features[3];
  EXPECT_EQ(count_colour(figure(place), {0, 0, 0}), place.area());
}

// A 40-pixel box round (160, 120) of a 320 x 240 image.
TEST(SaliencyFigure, BoxesAreDrawnWhereTheRegionsAre) {
  Described d = made_up(320, 240);
  d.signature.regions = {{160, 120, 1, {}}};
  const cv::Mat figure = saliency_figure(d.image, d.maps, d.signature, 10, "t");
  const SaliencyLayout layout = lay_out_saliency({320, 240}, 1);
  for (const cv::Rect& panel : {layout.image, layout.saliency}) {
    const double scale = panel.width / 320.0;
    const int left = panel.x + cvRound(140 * scale);
    const int right = panel.x + cvRound(180 * scale) - 1;
    const int top = panel.y + cvRound(100 * scale);
    const int bottom = panel.y + cvRound(140 * scale) - 1;
    const int middle_x = (left + right) / 2;
    const int middle_y = (top + bottom) / 2;
    for (const int inset : {0, 1}) {
      EXPECT_EQ(colour_at(figure, left + inset, middle_y), region_colour);
      EXPECT_EQ(colour_at(figure, right - inset, middle_y), region_colour);
      EXPECT_EQ(colour_at(figure, middle_x, top + inset), region_colour);
      EXPECT_EQ(colour_at(figure, middle_x, bottom - inset), region_colour);
    }
    EXPECT_EQ(colour_at(figure, left - 1, middle_y), cv::Vec3b(0, 0, 0));
    EXPECT_EQ(colour_at(figure, left + 2, middle_y), cv::Vec3b(0, 0, 0));
    // Its number stands in the upper left corner: a tag of the same colour with black digits.
    EXPECT_EQ(colour_at(figure, left + 3, top + 3), region_colour);
    EXPECT_GT(count_colour(figure(cv::Rect(left, top, 14, 16)), {0, 0, 0}), 3);
  }
  const cv::Mat bare = saliency_figure(d.image, d.maps, {320, 240, {}}, 10, "t");
  EXPECT_EQ(count_colour(bare, region_colour), 0);
  for (const cv::Rect& place : layout.features) {
    EXPECT_EQ(cv::norm(figure(place), bare(place), cv::NORM_INF), 0);
  }
}

TEST(SaliencyFigure, ABoxAtTheBorderIsCutThere) {
  Described d = made_up(320, 240);
  d.signature.regions = {{0, 0, 1, {}}, {316, 236, 0.5, {}}};
  const cv::Mat figure = saliency_figure(d.image, d.maps, d.signature, 10, "");
  const cv::Rect panel = lay_out_saliency({320, 240}, 0).image;
  const double scale = panel.width / 320.0;
  EXPECT_EQ(colour_at(figure, panel.x, panel.y), region_colour);
  EXPECT_EQ(colour_at(figure, panel.x + cvRound(20 * scale) - 1, panel.y + 5), region_colour);
  EXPECT_EQ(colour_at(figure, panel.x + cvRound(296 * scale), panel.br().y - 5), region_colour);
  EXPECT_EQ(colour_at(figure, panel.br().x - 1, panel.br().y - 5), region_colour);
  EXPECT_NE(colour_at(figure, panel.br().x, panel.br().y - 5), region_colour);
}

// Numbers of regions whose boxes overlap must all be readable: as many tags as regions, none upon another.
TEST(SaliencyFigure, RealRegionsOfAllShapesStayInTheirPanels) {
  for (const auto& [w, h] :
       {std::pair{64, 64}, {640, 480}, {1024, 64}, {64, 1024}, {640, 128}, {2048, 1500}}) {
    SCOPED_TRACE(std::to_string(w) + "x" + std::to_string(h));
    const Described d = described(picture(w, h));
    ASSERT_FALSE(d.signature.regions.empty());
    const std::string title =
        "a title that is much too long for one line, whatever the picture's shape may be, so that it is "
        "broken into "
        "several lines and so on and so on and "
        "a_word_without_any_space_that_is_wider_than_the_whole_figure_could_"
        "ever_be_because_some_paths_are_like_that_and_go_on_and_on_and_on_for_ever_and_ever_amen/0001.jpg";
    const cv::Mat figure = saliency_figure(d.image, d.maps, d.signature, 10, title);
    EXPECT_GT(figure.cols, 1200);
    EXPECT_LT(figure.cols, 1700);
    EXPECT_LT(figure.rows, 2600);
    // Nothing is cut: the outermost pixels are white.
    for (const cv::Rect& edge :
         {cv::Rect(0, 0, 20, figure.rows), cv::Rect(figure.cols - 20, 0, 20, figure.rows),
          cv::Rect(0, 0, figure.cols, 20), cv::Rect(0, figure.rows - 18, figure.cols, 18)}) {
      EXPECT_EQ(count_colour(figure(edge), white), edge.area());
    }
    EXPECT_GT(count_colour(figure, region_colour), 20);
  }
}

TEST(SaliencyFigure, NoTwoPanelsOfALayoutMeetAndCaptionsFit) {
  for (int w = 64; w <= 4096; w *= 2) {
    for (int h = 64; h <= 4096; h *= 2) {
      SCOPED_TRACE(std::to_string(w) + "x" + std::to_string(h));
      const SaliencyLayout layout = lay_out_saliency({w, h}, 2);
      std::vector<cv::Rect> panels(layout.features.begin(), layout.features.end());
      panels.insert(panels.end(), layout.conspicuities.begin(), layout.conspicuities.end());
      panels.insert(panels.end(), {layout.image, layout.saliency});
      const cv::Rect inside(SaliencyLayout::margin, SaliencyLayout::margin + 2 * SaliencyLayout::title_line,
                            layout.canvas.width - 2 * SaliencyLayout::margin, layout.canvas.height);
      for (cv::Rect& panel : panels) {
        // Shape kept, to the pixel.
        EXPECT_NEAR(panel.width, static_cast<double>(panel.height) * w / h, 0.5 + 0.5 * w / h);
        panel.height += SaliencyLayout::caption_room;
        EXPECT_EQ(panel & inside, panel);
        EXPECT_LE(panel.br().y, layout.canvas.height);
      }
      for (std::size_t a = 0; a < panels.size(); ++a) {
        for (std::size_t b = a + 1; b < panels.size(); ++b) EXPECT_EQ((panels[a] & panels[b]).area(), 0);
      }
      // Captions are centred beneath their panels and those of neighbours must not meet.
      const int widest =
          drawing::Text().width("intensity_off: max 0.0123, m = 123", SaliencyLayout::caption_size);
      for (const int room : layout.feature_rooms) EXPECT_GE(room, std::min(widest, 230));
      EXPECT_LT(layout.canvas.area(), 1700 * 2600);
    }
  }
}

TEST(SaliencyFigure, GreyImagesAndThoseWithAlphaAreShownToo) {
  Described d = made_up(128, 96);
  const cv::Mat grey(96, 128, CV_8UC1, cv::Scalar(77));
  const cv::Mat alpha(96, 128, CV_8UC4, cv::Scalar(10, 20, 30, 0));
  const cv::Rect place = lay_out_saliency({128, 96}, 0).image;
  const auto shown = [&](const cv::Mat& image) {
    return saliency_figure(image, d.maps, d.signature, 10, "")(place);
  };
  EXPECT_EQ(count_colour(shown(grey), {77, 77, 77}), place.area());
  EXPECT_EQ(count_colour(shown(alpha), {10, 20, 30}), place.area());
}

TEST(SaliencyFigure, RefusesWhatDoesNotBelongTogether) {
  const Described d = made_up(128, 96);
  const auto draw = [&](const cv::Mat& image, const Signature& signature, int box_side) {
    return [=, &d] { saliency_figure(image, d.maps, signature, box_side, "t"); };
  };
  EXPECT_THAT(draw({}, d.signature, 10), ThrowsMessage<Error>(HasSubstr("no image")));
  EXPECT_THAT(draw(cv::Mat(96, 128, CV_16UC1, cv::Scalar(0)), d.signature, 10),
              ThrowsMessage<Error>(HasSubstr("8-bit")));
  EXPECT_THAT(draw(picture(128, 100), d.signature, 10), ThrowsMessage<Error>(HasSubstr("128x100")));
  EXPECT_THAT(draw(d.image, {64, 96, {}}, 10), ThrowsMessage<Error>(HasSubstr("64x96")));
  EXPECT_THAT(draw(d.image, d.signature, 0), ThrowsMessage<Error>(HasSubstr("box side 0")));
  Described empty = made_up(128, 96);
  empty.maps.saliency.samples = Plane<double>();
  EXPECT_THAT([&] { saliency_figure(empty.image, empty.maps, empty.signature, 10, ""); },
              ThrowsMessage<Error>(HasSubstr("map is empty")));
}

}  // namespace
}  // namespace sailmap
