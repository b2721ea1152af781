// Figures: what must be where, checked on pixels; plots, read back as XML.
#include "sailmap/figures.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cmath>
#include <iomanip>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <pugixml.hpp>
#include <sstream>

#include "figures/score_raster.hpp"
#include "host/map_builders.hpp"
#include "sailmap/error.hpp"
#include "sailmap/frontend.hpp"
#include "sailmap/image_source.hpp"

namespace sailmap {
namespace {

namespace fs = std::filesystem;

class FiguresTest : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_ = fs::temp_directory_path() / ("sailmap-figures-" + std::to_string(::getpid()));
};

cv::Mat picture(int width, int height) {
  cv::Mat image(height, width, CV_8UC3, cv::Scalar(90, 90, 90));
  cv::rectangle(image, cv::Rect(width / 4, height / 4, width / 8, height / 8), cv::Scalar(0, 0, 255),
                cv::FILLED);
  cv::circle(image, {3 * width / 4, height / 2}, height / 10, cv::Scalar(255, 200, 0), cv::FILLED);
  return image;
}

struct Described {
  cv::Mat image;
  Maps maps;
  Signature signature;
};

Described described(int width, int height) {
  Described d;
  d.image = picture(width, height);
  make_frontend("reference")->compute(view_of(d.image), d.maps);
  d.signature = make_signature(d.maps, {});
  return d;
}

// How many pixels of `area` have exactly this colour.
int count_colour(const cv::Mat& image, const cv::Scalar& colour) {
  cv::Mat mask;
  cv::inRange(image, colour, colour, mask);
  return cv::countNonZero(mask);
}

TEST_F(FiguresTest, SaliencyFigureHoldsImageMapsAndRegions) {
  const Described d = described(320, 240);
  ASSERT_FALSE(d.signature.regions.empty());
  const cv::Mat figure = saliency_figure(d.image, d.maps, d.signature, 10, "title");
  EXPECT_GT(figure.cols, 1400);
  // The yellow of the region boxes appears, and goes when there are no regions.
  const cv::Scalar yellow(0, 220, 255);
  EXPECT_GT(count_colour(figure, yellow), 200);
  const cv::Mat bare = saliency_figure(d.image, d.maps, {320, 240, {}}, 10, "title");
  EXPECT_EQ(count_colour(bare, yellow), 0);
  EXPECT_EQ(bare.size(), figure.size());
  // The photograph itself is somewhere in it, at the size it was scaled to.
  cv::Mat scaled;
  const int width = (figure.cols - 2 * 24 - 14) / 2;
  cv::resize(d.image, scaled, {width, width * 3 / 4}, 0, 0, cv::INTER_NEAREST);
  cv::Mat score;
  cv::matchTemplate(bare, scaled, score, cv::TM_SQDIFF);
  double least = 0;
  cv::minMaxLoc(score, &least);
  EXPECT_LT(least, 1e-3 * static_cast<double>(scaled.total()));
}

TEST_F(FiguresTest, SaliencyFigureOfExtremeShapes) {
  for (const auto& [w, h] : {std::pair{64, 64}, {64, 640}, {640, 64}}) {
    const Described d = described(w, h);
    const cv::Mat figure = saliency_figure(d.image, d.maps, d.signature, 10, "title");
    EXPECT_GT(figure.rows, 400) << w << 'x' << h;
    EXPECT_LT(figure.rows, 6000) << w << 'x' << h;
  }
}

TEST_F(FiguresTest, MatchFigureJoinsMatchedRegions) {
  const Described d = described(320, 240);
  const MatchResult same = match(d.signature, d.signature, {});
  ASSERT_GE(same.matches.size(), 2U);
  const cv::Mat with = match_figure(d.image, d.image, d.signature, d.signature, same, 10, "the verdict");
  const cv::Mat without = match_figure(d.image, d.image, d.signature, d.signature, {}, 10, "the verdict");
  ASSERT_EQ(with.size(), without.size());
  // Lines cross the gap between the panels, which is white without them.
  const int middle = with.cols / 2;
  const cv::Rect gap(middle - 10, 20, 20, 400);
  EXPECT_EQ(count_colour(without(gap), cv::Scalar(255, 255, 255)), gap.area());
  EXPECT_LT(count_colour(with(gap), cv::Scalar(255, 255, 255)), gap.area());
}

TEST_F(FiguresTest, ALongVerdictIsWrapped) {
  const Described d = described(160, 120);
  std::string verdict;
  for (int i = 0; i < 60; ++i) verdict += "because of this and that ";
  const cv::Mat brief = match_figure(d.image, d.image, d.signature, d.signature, {}, 10, "no");
  const cv::Mat lengthy = match_figure(d.image, d.image, d.signature, d.signature, {}, 10, verdict);
  EXPECT_EQ(brief.cols, lengthy.cols);
  EXPECT_GT(lengthy.rows, brief.rows + 60);
}

TEST_F(FiguresTest, ImagesAreWrittenWholeOrNotAtAll) {
  const cv::Mat image = picture(80, 60);
  write_image(folder_ / "a.png", image);
  EXPECT_EQ(cv::norm(cv::imread((folder_ / "a.png").string()), image, cv::NORM_INF), 0);
  EXPECT_THROW(write_image(folder_ / "a.xyz", image), Error);
  EXPECT_THROW(write_image(folder_ / "none", image), Error);
  EXPECT_THROW(write_image(folder_ / "missing" / "a.png", image), Error);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST(ScoreRaster, SmallMatricesAreKeptAndTheCeilingIgnoresAFewGiants) {
  Plane<float> scores(50, 40, 2);
  scores(3, 4) = 1e6F;
  scores(7, 8) = not_admissible;
  GroundTruth truth;
  truth.matches.resize(40);
  truth.matches[4] = {3};
  truth.matches[8] = {7};
  const ScoreRaster raster = rasterise(scores, truth, 100);
  EXPECT_EQ(raster.step, 1);
  EXPECT_EQ(raster.cells(3, 4), 1e6F);
  EXPECT_TRUE(std::isnan(raster.cells(7, 8)));
  EXPECT_EQ(raster.is_match(3, 4), 1);
  EXPECT_EQ(raster.is_match(7, 8), 0);  // not admissible
  EXPECT_EQ(raster.ceiling, 2);
}

TEST(ScoreRaster, LargeMatricesShrinkToTheHighestOfEachBlock) {
  Plane<float> scores(250, 100, not_admissible);
  scores(0, 0) = 1;
  scores(2, 2) = 5;
  scores(249, 99) = 7;
  GroundTruth truth;
  truth.matches.resize(100);
  truth.matches[2] = {2};
  const ScoreRaster raster = rasterise(scores, truth, 100);
  EXPECT_EQ(raster.step, 3);
  EXPECT_EQ(raster.cells.width(), 84);
  EXPECT_EQ(raster.cells.height(), 34);
  EXPECT_EQ(raster.cells(0, 0), 5);
  EXPECT_EQ(raster.cells(83, 33), 7);
  EXPECT_TRUE(std::isnan(raster.cells(40, 10)));
  EXPECT_EQ(raster.is_match(0, 0), 1);
}

std::string all_text(const pugi::xml_document& document) {
  std::string text;
  for (const auto& found : document.select_nodes("//text")) {
    for (const auto& part : found.node().select_nodes(".//text()")) text += part.node().value();
    text += '\n';
  }
  return text;
}

TEST_F(FiguresTest, EvaluationPlotSaysTheFiguresAndIsSelfContained) {
  Plane<float> scores(30, 30, not_admissible);
  GroundTruth truth;
  truth.matches.resize(30);
  for (int q = 15; q < 30; ++q) {
    for (int c = 0; c <= q - 15; ++c) scores(c, q) = c == q - 15 ? static_cast<float>(q) : 1.0F;
    truth.matches[static_cast<std::size_t>(q)] = {q % 3 == 0 ? q - 14 : q - 15};
  }
  const Evaluation evaluation = evaluate(scores, truth, 20);
  const fs::path svg = folder_ / "plot.svg";
  write_evaluation_plot(svg, evaluation, scores, truth, "a \"quoted\" & <odd> title");
  pugi::xml_document document;
  ASSERT_TRUE(document.load_file(svg.c_str()));
  const std::string text = all_text(document);
  std::ostringstream average_precision;
  average_precision << "AP " << std::fixed << std::setprecision(3) << evaluation.average_precision;
  EXPECT_THAT(text, ::testing::HasSubstr(average_precision.str()));
  EXPECT_THAT(text, ::testing::HasSubstr("a \"quoted\" & <odd> title"));
  EXPECT_THAT(text, ::testing::HasSubstr("threshold 20"));
  for (const auto& image : document.select_nodes("//image")) {
    EXPECT_THAT(image.node().attribute("xlink:href").value(), ::testing::StartsWith("data:"));
  }
  EXPECT_THROW(write_evaluation_plot(folder_ / "missing" / "p.svg", evaluation, scores, truth, ""), Error);
}

TEST_F(FiguresTest, EvaluationPlotOfALargeMatrixStaysSmall) {
  Plane<float> scores(3000, 3000);
  GroundTruth truth;
  truth.matches.resize(3000);
  for (int q = 0; q < 3000; ++q) {
    for (int c = 0; c < 3000; ++c) scores(c, q) = static_cast<float>((q * 31 + c * 17) % 101);
    truth.matches[static_cast<std::size_t>(q)] = {q};
  }
  write_evaluation_plot(folder_ / "plot.svg", evaluate(scores, truth, 20), scores, truth, "large");
  EXPECT_LT(fs::file_size(folder_ / "plot.svg"), 2U << 20U);
}

TEST_F(FiguresTest, MapPlotHasANodeAndAnEdgeForEach) {
  const TopologicalMap map = testing::map_of({0, 1, 2, 3, 1, 4});
  write_map_plot(folder_ / "map.svg", map, "<map>");
  pugi::xml_document document;
  ASSERT_TRUE(document.load_file((folder_ / "map.svg").c_str(), pugi::parse_default));
  EXPECT_EQ(document.select_nodes("//g[@class='node']").size(), map.nodes().size());
  EXPECT_EQ(document.select_nodes("//g[@class='edge']").size(), map.edges().size());
  // The loop is coloured, the paths are grey.
  EXPECT_EQ(document.select_nodes("//g[@class='edge']//path[@stroke='#969696']").size(),
            map.edges().size() - 1);
  write_map_plot(folder_ / "empty.svg", TopologicalMap{}, "empty");
  EXPECT_TRUE(fs::exists(folder_ / "empty.svg"));
}

}  // namespace
}  // namespace sailmap
