// The bar chart, read back: heights and order of the bars, the words, what cannot be drawn.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

#include "figure_fixture.hpp"
#include "sailmap/error.hpp"
#include "sailmap/figures.hpp"

namespace sailmap {
namespace {

using testing::all_text;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
const std::string blue = "rgb(  0, 114, 178)";
const std::string orange = "rgb(230, 159,   0)";

struct Bar {
  double left, right, bottom, top;
  [[nodiscard]] double height() const { return bottom - top; }
};

// Of each fill the rectangles, from the left; the key's samples are lower than any bar.
std::map<std::string, std::vector<Bar>> bars_of(const pugi::xml_document& document) {
  std::map<std::string, std::vector<Bar>> out;
  for (const auto& found : document.select_nodes("//polygon")) {
    Bar bar{1e9, -1e9, -1e9, 1e9};
    std::string points = found.node().attribute("points").value();
    std::ranges::replace(points, ',', ' ');
    std::istringstream in(points);
    for (double x = 0, y = 0; in >> x >> y;) {
      bar = {std::min(bar.left, x), std::max(bar.right, x), std::max(bar.bottom, y), std::min(bar.top, y)};
    }
    if (bar.height() > 15) out[found.node().attribute("fill").value()].push_back(bar);
  }
  for (auto& [fill, bars] : out) {
    std::ranges::sort(
        bars, [](const Bar& a, const Bar& b) { return a.bottom + a.left * 1e-4 < b.bottom + b.left * 1e-4; });
  }
  return out;
}

class BarChartTest : public testing::FigureTest {
 protected:
  pugi::xml_document drawn(const std::vector<std::string>& groups, const std::vector<std::string>& series,
                           const std::vector<BarPanel>& panels) {
    const auto svg = folder_ / "bars.svg";
    write_bar_chart(svg, "It's \"all\" `here`", groups, series, panels);
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_file(svg.c_str());
    EXPECT_TRUE(parsed) << parsed.description();
    return document;
  }
};

TEST_F(BarChartTest, HeightsAreTheValues) {
  const auto document = drawn({"here", "there"}, {"one", "two"},
                              {{"upper", {{1.0, 0.5}, {0.25, none}}}, {"lower", {{0.8, 0.2}, {0.4, 0.6}}}});
  const auto bars = bars_of(document);
  ASSERT_EQ(bars.at(blue).size(), 4U);
  ASSERT_EQ(bars.at(orange).size(), 3U);
  const Bar& whole = bars.at(blue)[0];
  const auto part = [&whole](const Bar& bar) { return bar.height() / whole.height(); };
  constexpr double pixel = 0.01;
  EXPECT_NEAR(part(bars.at(blue)[1]), 0.25, pixel);
  EXPECT_NEAR(part(bars.at(blue)[2]), 0.8, pixel);
  EXPECT_NEAR(part(bars.at(blue)[3]), 0.4, pixel);
  EXPECT_NEAR(part(bars.at(orange)[0]), 0.5, pixel);
  EXPECT_NEAR(part(bars.at(orange)[1]), 0.2, pixel);
  EXPECT_NEAR(part(bars.at(orange)[2]), 0.6, pixel);
  // Side by side within a group, apart from the next group; the second panel beneath the first.
  EXPECT_NEAR(whole.right, bars.at(orange)[0].left, 1);
  EXPECT_GT(bars.at(blue)[1].left - bars.at(orange)[0].right, 20);
  EXPECT_GT(bars.at(blue)[2].top, whole.bottom);
  const std::string text = all_text(document);
  for (const char* word : {"here\n", "there\n", "one\n", "two\n", "upper\n", "lower\n",
                           "It's \"all\" `here`\n", "100\n", "50\n", "25\n"}) {
    EXPECT_THAT(text, HasSubstr(word));
  }
}

TEST_F(BarChartTest, ManySeriesAndLongNames) {
  std::vector<std::string> groups;
  std::vector<std::string> series;
  for (int i = 0; i < 8; ++i) groups.push_back("A data set of some length " + std::to_string(i));
  for (int i = 0; i < 10; ++i) series.push_back("method number " + std::to_string(i));
  BarPanel panel{"Recall (%)", {}};
  for (std::size_t g = 0; g < 8; ++g) panel.values.emplace_back(10, 0.1 * static_cast<double>(g + 2));
  const auto document = drawn(groups, series, {panel, panel});
  // The ninth and tenth have the colours of the first two, but hatched.
  EXPECT_EQ(bars_of(document).at(blue).size(), 16U);
  EXPECT_FALSE(document.select_nodes("//pattern").empty());
  for (const std::string& name : groups) EXPECT_THAT(all_text(document), HasSubstr(name));
  for (const std::string& name : series) EXPECT_THAT(all_text(document), HasSubstr(name));
  for (const auto& found : document.select_nodes("//polygon")) {
    std::string points = found.node().attribute("points").value();
    EXPECT_THAT(points, Not(HasSubstr("-")));
  }
}

TEST_F(BarChartTest, ASeriesWithoutBarsIsStillNamed) {
  const auto document = drawn({"here"}, {"one", "two"}, {{"panel", {{none, 0.5}}}});
  EXPECT_EQ(bars_of(document).count(blue), 0U);
  EXPECT_THAT(all_text(document), HasSubstr("one\n"));
}

TEST_F(BarChartTest, RefusesWhatCannotBeDrawn) {
  const auto refuse = [this](const std::vector<std::vector<double>>& values, const std::string& fault) {
    EXPECT_THAT(
        [&] {
          drawn({"here"}, {"one", "two"}, {{"panel", values}});
        },
        ThrowsMessage<Error>(AllOf(HasSubstr("bars.svg: "), HasSubstr(fault))));
    EXPECT_EQ(files(), 0);
  };
  refuse({{0.5}}, "do not fit");
  refuse({{0.5, 0.5}, {0.5, 0.5}}, "do not fit");
  refuse({{none, none}}, "nothing to draw");
  refuse({}, "do not fit");
}

}  // namespace
}  // namespace sailmap
