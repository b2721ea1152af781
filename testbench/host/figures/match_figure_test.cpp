// The match figure: both images, the regions and what joins them.
#include <gmock/gmock.h>

#include "figure_fixture.hpp"
#include "figures/drawing.hpp"
#include "figures/match_layout.hpp"
#include "sailmap/error.hpp"
#include "sailmap/figures.hpp"

namespace sailmap {
namespace {

using testing::bytes;
using testing::colour_at;
using testing::count_colour;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const cv::Vec3b thin_colour(215, 215, 215);
const cv::Vec3b white(255, 255, 255);

cv::Mat flat(int width, int height, int grey) { return {height, width, CV_8UC3, cv::Scalar::all(grey)}; }

Signature regions_at(int width, int height, const std::vector<cv::Point>& places) {
  Signature s{width, height, {}};
  for (const cv::Point& at : places)
    s.regions.push_back({static_cast<std::int16_t>(at.x), static_cast<std::int16_t>(at.y), 1, {}});
  return s;
}

// Two flat images of 960 x 540 with one matched and one lone region each.
struct Drawn {
  Signature a = regions_at(960, 540, {{800, 400}, {240, 240}});
  Signature b = regions_at(960, 540, {{240, 320}, {600, 80}});
  MatchResult match{7.5, {{1, 0, 0.25}}};
  MatchLayout layout = lay_out_match({960, 540}, {960, 540}, 1);
  cv::Mat with = match_figure(flat(960, 540, 60), flat(960, 540, 90), a, b, match, 10, "the verdict");
  cv::Mat without = match_figure(flat(960, 540, 60), flat(960, 540, 90), a, b, {}, 10, "the verdict");
};

TEST(MatchFigure, ShowsBothImagesSideBySideAtOneSize) {
  const Drawn d;
  ASSERT_EQ(d.with.size(), d.layout.canvas);
  EXPECT_EQ(d.with.cols, 1600);
  EXPECT_EQ(d.layout.query.y, d.layout.candidate.y);
  EXPECT_EQ(d.layout.query.size(), d.layout.candidate.size());
  EXPECT_NEAR(d.layout.query.width * 540.0 / 960, d.layout.query.height, 1);
  EXPECT_GT(count_colour(d.without(d.layout.query), {60, 60, 60}), 9 * d.layout.query.area() / 10);
  EXPECT_GT(count_colour(d.without(d.layout.candidate), {90, 90, 90}), 9 * d.layout.candidate.area() / 10);
}

// The pixel that a level-0 point of an image is drawn at.
cv::Point placed(const cv::Rect& panel, double x, double y) {
  return {panel.x + cvRound(x * panel.width / 960), panel.y + cvRound(y * panel.height / 540)};
}

TEST(MatchFigure, MatchedBoxesAreThickAndColouredOthersThin) {
  const Drawn d;
  const cv::Vec3b colour = bytes(drawing::distinct_colour(0));
  // Left edges half-way down: box 40 level-0 pixels wide round the region.
  const auto left_edge = [](const cv::Rect& panel, int x, int y) { return placed(panel, x - 20, y + 10); };
  for (const cv::Point& edge :
       {left_edge(d.layout.query, 240, 240), left_edge(d.layout.candidate, 240, 320)}) {
    for (int i = 0; i < 3; ++i) EXPECT_EQ(colour_at(d.with, edge.x + i, edge.y), colour) << i;
    EXPECT_EQ(colour_at(d.without, edge.x, edge.y), thin_colour);
    EXPECT_EQ(colour_at(d.without, edge.x + 1, edge.y), cv::Vec3b(0, 0, 0));
  }
  for (const cv::Point& edge :
       {left_edge(d.layout.query, 800, 400), left_edge(d.layout.candidate, 600, 80)}) {
    EXPECT_EQ(colour_at(d.with, edge.x, edge.y), thin_colour);
    EXPECT_EQ(colour_at(d.with, edge.x + 1, edge.y), cv::Vec3b(0, 0, 0));
  }
}

TEST(MatchFigure, ALineJoinsTheCentresAndCarriesTheDistance) {
  const Drawn d;
  const cv::Vec3b colour = bytes(drawing::distinct_colour(0));
  const cv::Point from = placed(d.layout.query, 240, 240);
  const cv::Point to = placed(d.layout.candidate, 240, 320);
  for (const double part : {0.1, 0.25, 0.4, 0.6, 0.75}) {
    const int x = cvRound(from.x + part * (to.x - from.x));
    const int y = cvRound(from.y + part * (to.y - from.y));
    EXPECT_EQ(colour_at(d.with, x, y), colour) << part;
  }
  // The label is a filled box half-way, higher than the line, with black digits.
  const cv::Point middle = (from + to) / 2;
  const cv::Rect label(middle.x - 14, middle.y - 7, 28, 14);
  EXPECT_GT(count_colour(d.with(label), colour), label.area() / 3);
  EXPECT_GT(count_colour(d.with(label), {0, 0, 0}), 10);
  const cv::Rect between(d.layout.query.br().x, d.layout.query.y,
                         d.layout.candidate.x - d.layout.query.br().x, d.layout.query.height);
  EXPECT_EQ(count_colour(d.without(between), white), between.area());
}

TEST(MatchFigure, TheVerdictIsWrappedBeneathTheImages) {
  const auto draw = [](const std::string& verdict) {
    return match_figure(flat(160, 120, 60), flat(160, 120, 90), regions_at(160, 120, {}),
                        regions_at(160, 120, {}), {}, 10, verdict);
  };
  std::string lengthy = "no";
  for (int i = 0; i < 60; ++i) lengthy += " because of this and that";
  const cv::Mat brief = draw("no");
  const cv::Mat full = draw(lengthy);
  EXPECT_EQ(brief.cols, full.cols);
  const auto lines =
      drawing::Text().wrapped(lengthy, MatchLayout::verdict_size, MatchLayout::text_width).size();
  EXPECT_GE(lines, 8U);
  EXPECT_EQ(full.rows, brief.rows + static_cast<int>(lines - 1) * MatchLayout::verdict_line);
  // Nothing is cut off at the right, and the last line is there.
  EXPECT_EQ(count_colour(full.colRange(full.cols - 20, full.cols), white), 20 * full.rows);
  const int last = full.rows - MatchLayout::margin - MatchLayout::verdict_line;
  EXPECT_LT(count_colour(full.rowRange(last, full.rows - MatchLayout::margin), white),
            MatchLayout::verdict_line * full.cols);
}

TEST(MatchFigure, SmallImagesAreEnlargedLargeOnesReduced) {
  for (const auto& [w, h] : {std::pair{160, 120}, {64, 64}, {4096, 4096}, {4096, 3000}}) {
    const MatchLayout layout = lay_out_match({w, h}, {w, h}, 1);
    EXPECT_GE(layout.query.height, 550) << w;
    EXPECT_LE(layout.query.height, 760) << w;
    EXPECT_EQ(layout.canvas.width, 1600);
  }
}

TEST(MatchFigure, NoShapeMakesPanelsMeetOrLeaveTheFigure) {
  for (int w = 64; w <= 4096; w *= 2) {
    for (int h = 64; h <= 4096; h *= 2) {
      const MatchLayout layout = lay_out_match({w, h}, {h, w}, 3);
      const cv::Rect canvas({0, 0}, layout.canvas);
      const cv::Rect inner(MatchLayout::margin, MatchLayout::margin + MatchLayout::caption_room,
                           canvas.width - 2 * MatchLayout::margin, canvas.height);
      EXPECT_EQ(layout.query & inner, layout.query) << w << 'x' << h;
      EXPECT_EQ(layout.candidate & inner, layout.candidate) << w << 'x' << h;
      EXPECT_EQ((layout.query & layout.candidate).area(), 0) << w << 'x' << h;
      EXPECT_GT(layout.legend.y, std::max(layout.query.br().y, layout.candidate.br().y));
      EXPECT_LT(layout.verdict.y + 2 * MatchLayout::verdict_line, canvas.height);
    }
  }
}

TEST(MatchFigure, LabelsEvadeOneAnotherAndTheBoxes) {
  // Twelve lines so close together that labels half-way would lie on each other.
  std::vector<LabelledLine> lines;
  std::vector<cv::Rect> boxes;
  for (int k = 0; k < 12; ++k) {
    lines.push_back({{100, 200 + 6 * k}, {900, 210 + 6 * k}, {40, 18}});
    boxes.emplace_back(450, 190, 60, 100);
  }
  const std::vector<cv::Rect> labels = place_labels(lines, boxes);
  ASSERT_EQ(labels.size(), lines.size());
  for (std::size_t a = 0; a < labels.size(); ++a) {
    EXPECT_EQ((labels[a] & boxes[0]).area(), 0) << a;
    for (std::size_t b = a + 1; b < labels.size(); ++b)
      EXPECT_EQ((labels[a] & labels[b]).area(), 0) << a << ' ' << b;
    // On its line.
    const double x = labels[a].x + labels[a].width / 2.0;
    const double y = 200 + 6.0 * static_cast<double>(a) + 10 * (x - 100) / 800;
    EXPECT_NEAR(labels[a].y + labels[a].height / 2.0, y, 1.5);
    EXPECT_GT(x, 100);
    EXPECT_LT(x, 900);
  }
}

TEST(MatchFigure, ALabelWithoutAFreePlaceIsStillDrawn) {
  const std::vector<cv::Rect> everywhere = {{0, 0, 500, 500}};
  EXPECT_EQ(place_labels({{{100, 100}, {110, 100}, {40, 18}}}, everywhere).size(), 1U);
}

TEST(MatchFigure, RefusesWhatDoesNotBelongTogether) {
  const Drawn d;
  const auto draw = [&](const cv::Mat& a, const cv::Mat& b, const MatchResult& match, int box_side) {
    return [=, &d] { match_figure(a, b, d.a, d.b, match, box_side, "v"); };
  };
  const cv::Mat image = flat(960, 540, 0);
  EXPECT_THAT(draw({}, image, {}, 10), ThrowsMessage<Error>(HasSubstr("query: there is no image")));
  EXPECT_THAT(draw(image, {}, {}, 10), ThrowsMessage<Error>(HasSubstr("candidate: there is no image")));
  EXPECT_THAT(draw(flat(960, 500, 0), image, {}, 10), ThrowsMessage<Error>(HasSubstr("query is 960x500")));
  EXPECT_THAT(draw(image, flat(100, 540, 0), {}, 10),
              ThrowsMessage<Error>(HasSubstr("candidate is 100x540")));
  EXPECT_THAT(draw(image, image, {1, {{2, 0, 1}}}, 10), ThrowsMessage<Error>(HasSubstr("regions 2 and 0")));
  EXPECT_THAT(draw(image, image, {1, {{0, -1, 1}}}, 10), ThrowsMessage<Error>(HasSubstr("regions 0 and -1")));
  EXPECT_THAT(draw(image, image, {}, 0), ThrowsMessage<Error>(HasSubstr("box side 0")));
}

}  // namespace
}  // namespace sailmap
