// The evaluation plot, read back: the curve's points, the matrix's pixels, the words.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <boost/archive/iterators/binary_from_base64.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cmath>
#include <cstdlib>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "figure_fixture.hpp"
#include "sailmap/error.hpp"
#include "sailmap/evaluation.hpp"
#include "sailmap/figures.hpp"

namespace sailmap {
namespace {

namespace fs = std::filesystem;
using testing::all_text;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

struct Experiment {
  Plane<float> scores;
  GroundTruth truth;
  Evaluation evaluation;
};

// A lap of `lap` images driven twice and more: high scores, partly, where the truth is; one pair identical.
Experiment laps(int images, int lap) {
  Experiment e;
  e.scores = Plane<float>(images, images, not_admissible);
  e.truth.matches.resize(static_cast<std::size_t>(images));
  std::mt19937 random(7);
  for (int q = 0; q < images; ++q) {
    for (int c = 0; c + 5 < q; ++c) {
      e.scores(c, q) = static_cast<float>(random() % 900) / 100;
      if (std::abs(q - lap - c) > 1) continue;
      e.truth.matches[static_cast<std::size_t>(q)].push_back(c);
      if (random() % 3 != 0) e.scores(c, q) += static_cast<float>(random() % 30);
    }
  }
  e.scores(0, lap) = 1e6F;
  e.evaluation = evaluate(e.scores, e.truth, 12);
  return e;
}

class EvaluationPlotTest : public testing::FigureTest {
 protected:
  // The plot as XML.
  pugi::xml_document plotted(const Experiment& e, const std::string& title) {
    write_evaluation_plot(svg_, e.evaluation, e.scores, e.truth, title);
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_file(svg_.c_str());
    EXPECT_TRUE(parsed) << parsed.description();
    return document;
  }
  void SetUp() override {
    FigureTest::SetUp();
    svg_ = folder_ / "plot.svg";
  }

  fs::path svg_;
};

// Polylines of a path, "M x,y L x,y ... M ...".
std::vector<std::vector<cv::Point2d>> polylines(const std::string& d) {
  std::vector<std::vector<cv::Point2d>> out;
  std::istringstream in(d);
  for (std::string word; in >> word;) {
    if (word[0] == 'M') out.emplace_back();
    const std::size_t comma = word.find(',');
    out.back().emplace_back(std::stod(word.substr(1)), std::stod(word.substr(comma + 1)));
  }
  return out;
}

std::string path_of_colour(const pugi::xml_document& document, const char* stroke) {
  std::string all;
  for (const auto& found : document.select_nodes("//path")) {
    if (std::string(found.node().attribute("stroke").value()) == stroke)
      all += found.node().attribute("d").value();
  }
  return all;
}

// Where the axes lie on the page: the image of the matrix fills its own, and both panels stand at one height.
struct Frame {
  double x = 0, y = 0, width = 0, height = 0;
};
Frame matrix_frame(const pugi::xml_document& document) {
  const pugi::xml_node image = document.select_node("//image").node();
  return {image.attribute("x").as_double(), image.attribute("y").as_double(),
          image.attribute("width").as_double(), image.attribute("height").as_double()};
}

TEST_F(EvaluationPlotTest, TheCurveIsTheEvaluations) {
  const Experiment e = laps(80, 30);
  const pugi::xml_document document = plotted(e, "laps");
  std::vector<cv::Point2d> curve;
  for (const auto& line : polylines(path_of_colour(document, "rgb( 31, 119, 180)"))) {
    if (line.size() > 2) curve = line;  // the other one is the sample in the legend
  }
  const Frame frame = matrix_frame(document);
  ASSERT_EQ(curve.size(), e.evaluation.curve.size() + 1);
  const double left = curve[0].x;  // recall 0
  EXPECT_NEAR(curve[0].y, frame.y + (1 - e.evaluation.curve[0].precision) * frame.height, 0.1);
  for (std::size_t i = 0; i < e.evaluation.curve.size(); ++i) {
    EXPECT_NEAR(curve[i + 1].x, left + e.evaluation.curve[i].recall * frame.width, 0.1);
    EXPECT_NEAR(curve[i + 1].y, frame.y + (1 - e.evaluation.curve[i].precision) * frame.height, 0.1);
  }
  // The dot of the fixed threshold: transform='translate(x,y) ...'.
  bool found = false;
  for (const auto& use : document.select_nodes("//use")) {
    double x = 0;
    double y = 0;
    if (std::sscanf(use.node().attribute("transform").value(), "translate(%lf,%lf)", &x, &y) != 2) continue;
    found = found || (std::abs(x - left - e.evaluation.fixed.recall * frame.width) < 0.1 &&
                      std::abs(y - frame.y - (1 - e.evaluation.fixed.precision) * frame.height) < 0.1);
  }
  EXPECT_TRUE(found);
}

cv::Mat embedded_picture(const pugi::xml_document& document) {
  const std::string link = document.select_node("//image").node().attribute("xlink:href").value();
  const std::string head = "data:image/png;base64,";
  EXPECT_THAT(link, StartsWith(head));
  namespace it = boost::archive::iterators;
  using Decoded = it::transform_width<it::binary_from_base64<std::string::const_iterator>, 8, 6>;
  const auto from = link.begin() + static_cast<std::ptrdiff_t>(head.size());
  const auto to = std::find(from, link.end(), '=');
  std::vector<std::uint8_t> png;
  const auto length = (to - from) * 6 / 8;
  std::copy_n(Decoded(from), length, std::back_inserter(png));
  return cv::imdecode(png, cv::IMREAD_UNCHANGED);
}

TEST_F(EvaluationPlotTest, TheMatrixIsAPictureOfItsScores) {
  const Experiment e = laps(80, 30);
  const pugi::xml_document document = plotted(e, "laps");
  ASSERT_EQ(document.select_nodes("//image").size(), 1U);
  const cv::Mat picture = embedded_picture(document);
  ASSERT_EQ(picture.channels(), 4);
  ASSERT_EQ(picture.cols % 80, 0);
  ASSERT_EQ(picture.size(), cv::Size(picture.cols, picture.cols));
  const int times = picture.cols / 80;
  EXPECT_GE(picture.cols, 600);
  // The higher the score the darker its pixels; NaN is transparent; all pixels of a cell are alike.
  std::vector<std::pair<float, int>> shown;
  for (int q = 0; q < 80; ++q) {
    for (int c = 0; c < 80; ++c) {
      const auto& pixel = picture.at<cv::Vec4b>(q * times + times / 2, c * times + times / 2);
      ASSERT_EQ(picture.at<cv::Vec4b>(q * times, c * times), pixel);
      ASSERT_EQ(picture.at<cv::Vec4b>((q + 1) * times - 1, (c + 1) * times - 1), pixel);
      if (std::isnan(e.scores(c, q))) {
        EXPECT_EQ(pixel[3], 0) << q << ' ' << c;
      } else {
        EXPECT_EQ(pixel[3], 255);
        shown.emplace_back(e.scores(c, q), pixel[0] + pixel[1] + pixel[2]);
      }
    }
  }
  std::sort(shown.begin(), shown.end());
  for (std::size_t i = 1; i < shown.size(); ++i) EXPECT_LE(shown[i].second, shown[i - 1].second);
  // One score of a million does not make all others look like 0.
  EXPECT_EQ(shown.back().first, 1e6F);
  EXPECT_LT(shown[shown.size() / 2].second, shown.front().second - 20);
  EXPECT_GT(shown.front().second, 600);
  EXPECT_LT(shown.back().second, 150);
}

TEST_F(EvaluationPlotTest, OutlinesHoldTheGroundTruth) {
  const Experiment e = laps(80, 30);
  const pugi::xml_document document = plotted(e, "laps");
  const Frame frame = matrix_frame(document);
  const auto lines = polylines(path_of_colour(document, "rgb(227,  26,  28)"));
  ASSERT_GT(lines.size(), 20U);
  const auto inside = [&](int query, int candidate) {
    const double x = frame.x + (candidate + 0.5) * frame.width / 80;
    const double y = frame.y + (query + 0.5) * frame.height / 80;
    int crossed = 0;
    for (const auto& line : lines) {
      for (std::size_t i = 1; i < line.size(); ++i) {
        const bool upright = std::abs(line[i].x - line[i - 1].x) < 0.01;
        if (upright && line[i].x < x && (line[i].y < y) != (line[i - 1].y < y)) ++crossed;
      }
    }
    return crossed % 2 == 1;
  };
  for (int q = 0; q < 80; ++q) {
    const auto& matches = e.truth.matches[static_cast<std::size_t>(q)];
    for (int c = 0; c < 80; ++c) {
      const bool match = std::count(matches.begin(), matches.end(), c) > 0;
      EXPECT_EQ(inside(q, c), match && !std::isnan(e.scores(c, q))) << q << ' ' << c;
    }
  }
}

TEST_F(EvaluationPlotTest, SaysItsNumbersAndIsSelfContained) {
  const Experiment e = laps(80, 30);
  // What a shell, gnuplot's markup or XML would take for their own.
  const std::string title =
      "a 'title' \"of\" `touch " + (folder_ / "evil").string() + "` <odd> & x_{1} caf\xC3\xA9 %s \\n";
  const pugi::xml_document document = plotted(e, title);
  const std::string text = all_text(document);
  std::ostringstream average_precision;
  average_precision.precision(3);
  average_precision << "average precision " << std::fixed << e.evaluation.average_precision;
  std::ostringstream fixed;
  fixed.precision(3);
  fixed << "threshold 12: precision " << std::fixed << e.evaluation.fixed.precision << ", recall "
        << e.evaluation.fixed.recall;
  EXPECT_THAT(text,
              AllOf(HasSubstr(title), HasSubstr(average_precision.str()), HasSubstr(fixed.str()),
                    HasSubstr("clipped at"), HasSubstr("99.5th percentile"), HasSubstr("ground truth")));
  EXPECT_FALSE(fs::exists(folder_ / "evil"));
  EXPECT_EQ(files(), 1);
  for (const auto& found : document.select_nodes("//@*")) {
    const std::string name = found.attribute().name();
    if (name != "xlink:href" && name != "href") continue;
    EXPECT_THAT(found.attribute().value(), ::testing::AnyOf(StartsWith("data:"), StartsWith("#")));
  }
}

TEST_F(EvaluationPlotTest, LongAndImproperTitlesAreShownAsFarAsPossible) {
  const Experiment e = laps(40, 15);
  std::string title = "bad\xFF byte\n";
  for (int i = 0; i < 40; ++i) title += "long title ";
  const std::string text = all_text(plotted(e, title));
  EXPECT_THAT(text, HasSubstr("bad byte long title"));
  const std::string once = "long title";
  int count = 0;
  for (std::size_t at = text.find("title"); at != std::string::npos; at = text.find("title", at + 1)) ++count;
  EXPECT_EQ(count, 40);
  plotted(e, "");
}

TEST_F(EvaluationPlotTest, ALargeMatrixIsReducedToASmallFile) {
  const int images = 3000;
  Experiment e;
  e.scores = Plane<float>(images, images);
  e.truth.matches.resize(images);
  std::mt19937 random(1);
  for (float& score : e.scores.samples()) score = static_cast<float>(random() % 1000);
  for (int q = 0; q < images; ++q) e.truth.matches[static_cast<std::size_t>(q)] = {q, (q * 7) % images};
  e.scores(2000, 1000) = 5000;
  e.evaluation = evaluate(e.scores, e.truth, 20);
  const pugi::xml_document document = plotted(e, "large");
  EXPECT_LT(fs::file_size(svg_), 2U << 20U);
  const cv::Mat picture = embedded_picture(document);
  EXPECT_EQ(picture.size(), cv::Size(800, 800));
  EXPECT_THAT(all_text(document), HasSubstr("each cell the highest of 3.75 x 3.75 images"));
}

TEST_F(EvaluationPlotTest, TwoTraversesOfUnlikeLengthKeepTheirShape) {
  Experiment e;
  e.scores = Plane<float>(120, 40, 1);
  e.truth.matches.resize(40);
  for (int q = 0; q < 40; ++q) {
    e.scores(3 * q, q) = 20;
    e.truth.matches[static_cast<std::size_t>(q)] = {3 * q};
  }
  e.evaluation = evaluate(e.scores, e.truth, 12);
  const Frame frame = matrix_frame(plotted(e, "traverses"));
  EXPECT_NEAR(frame.width, 3 * frame.height, 1);
}

TEST_F(EvaluationPlotTest, RefusesWhatCannotBeDrawn) {
  const Experiment e = laps(40, 15);
  const auto plot = [&](const fs::path& path, const Evaluation& evaluation, const Plane<float>& scores) {
    return [=, &e] { write_evaluation_plot(path, evaluation, scores, e.truth, "t"); };
  };
  EXPECT_THAT(plot(svg_, {}, e.scores), ThrowsMessage<Error>(HasSubstr("no precision-recall curve")));
  EXPECT_THAT(plot(svg_, e.evaluation, Plane<float>(10, 10)), ThrowsMessage<Error>(HasSubstr("40 queries")));
  const fs::path nowhere = folder_ / "missing" / "plot.svg";
  EXPECT_THAT(plot(nowhere, e.evaluation, e.scores), ThrowsMessage<Error>(HasSubstr(nowhere.string())));
  EXPECT_EQ(files(), 0);
}

// With another gnuplot first in PATH, or none.
class BrokenGnuplotTest : public EvaluationPlotTest {
 protected:
  void SetUp() override {
    EvaluationPlotTest::SetUp();
    path_ = std::getenv("PATH");
    bin_ = folder_ / "bin";
    temporary_ = folder_ / "tmp";
    fs::create_directories(bin_);
    fs::create_directories(temporary_);
    ::setenv("PATH", bin_.c_str(), 1);
    ::setenv("TMPDIR", temporary_.c_str(), 1);
    std::ofstream(svg_) << "as it was";
  }
  void TearDown() override {
    ::setenv("PATH", path_.c_str(), 1);
    ::unsetenv("TMPDIR");
    EvaluationPlotTest::TearDown();
  }
  void use_gnuplot(const std::string& script) const {
    std::ofstream(bin_ / "gnuplot") << "#!/bin/sh\n" << script << '\n';
    ::chmod((bin_ / "gnuplot").c_str(), 0755);
  }
  void expect_error(const std::string& fault) const {
    const Experiment e = laps(40, 15);
    EXPECT_THAT([&] { write_evaluation_plot(svg_, e.evaluation, e.scores, e.truth, "t"); },
                ThrowsMessage<Error>(AllOf(StartsWith(svg_.string()), HasSubstr(fault))));
    EXPECT_EQ(contents(svg_), "as it was");
    EXPECT_TRUE(fs::is_empty(temporary_));
    EXPECT_EQ(files(), 3);  // bin, tmp and the plot
  }

  std::string path_;
  fs::path bin_;
  fs::path temporary_;
};

TEST_F(BrokenGnuplotTest, Missing) { expect_error("gnuplot is needed"); }

TEST_F(BrokenGnuplotTest, FailingSaysWhy) {
  use_gnuplot("echo 'line 3: unknown terminal' >&2; exit 1");
  expect_error("status 1: line 3: unknown terminal");
}

TEST_F(BrokenGnuplotTest, APlotOfAFailureIsNoPlot) {
  use_gnuplot("echo '<svg></svg>'; exit 3");
  expect_error("status 3");
}

TEST_F(BrokenGnuplotTest, HalfAPlotIsNoPlot) {
  use_gnuplot("echo '<svg><path d='");
  expect_error("gnuplot failed");
}

TEST_F(BrokenGnuplotTest, Dying) {
  use_gnuplot("kill -9 $$");
  expect_error("gnuplot failed");
}

TEST_F(BrokenGnuplotTest, NoProgramAtAll) {
  std::ofstream(bin_ / "gnuplot") << "#!/no/such/interpreter\n";
  ::chmod((bin_ / "gnuplot").c_str(), 0755);
  expect_error("gnuplot");
}

TEST_F(BrokenGnuplotTest, NoPlaceForItsFiles) {
  ::setenv("TMPDIR", (folder_ / "none").c_str(), 1);
  const Experiment e = laps(40, 15);
  EXPECT_THAT([&] { write_evaluation_plot(svg_, e.evaluation, e.scores, e.truth, "t"); },
              ThrowsMessage<Error>(HasSubstr("TMPDIR")));
}

}  // namespace
}  // namespace sailmap
