// The parts of the report that a page does not show plainly.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "host/map_builders.hpp"
#include "report/base64.hpp"
#include "report/graph.hpp"
#include "report/page.hpp"
#include "report/pairs.hpp"
#include "report/subject.hpp"
#include "sailmap/error.hpp"

namespace sailmap::report {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::string encoded(std::string_view text) {
  return base64(std::vector<std::uint8_t>(text.begin(), text.end()));
}

// RFC 4648, section 10.
TEST(Base64, TestVectorsOfTheStandard) {
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foob"), "Zm9vYg==");
  EXPECT_EQ(encoded("fooba"), "Zm9vYmE=");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
  EXPECT_EQ(encoded("\xff\xfe\xfd"), "//79");
}

Loop loop_of(double score, double rival_score, std::optional<bool> right = std::nullopt) {
  Loop loop;
  loop.views = {0};
  loop.score = score;
  loop.rival = 1;
  loop.rival_score = rival_score;
  loop.right = right;
  return loop;
}

TEST(Margin, IsToTheNearerOfThresholdAndRunnerUp) {
  EXPECT_DOUBLE_EQ(margin(loop_of(10, 8), 5), 0.2);
  EXPECT_DOUBLE_EQ(margin(loop_of(10, 1), 9), 0.1);
  Loop alone = loop_of(10, 9.9);
  alone.rival = -1;
  EXPECT_DOUBLE_EQ(margin(alone, 5), 0.5);
  // Log-odds may be negative.
  EXPECT_DOUBLE_EQ(margin(loop_of(-2, -9), -4), 0.5);
}

TEST(PickLoops, WrongOnesThenStrongestWeakestAndDoubtfulInTurnEachOnce) {
  Subject subject;
  subject.threshold = 1;
  subject.loops = {loop_of(9, 0), loop_of(2, 0), loop_of(5, 4.9), loop_of(6, 0, false), loop_of(7, 0)};
  const auto picks = pick_loops(subject, 4);
  std::vector<std::size_t> loops;
  std::vector<std::string> why;
  for (const Pick& pick : picks) {
    loops.push_back(pick.loop);
    why.emplace_back(pick.why);
  }
  EXPECT_THAT(loops, ElementsAre(3, 0, 1, 2));
  EXPECT_THAT(why, ElementsAre("wrong", "strongest", "weakest", "doubtful"));
  EXPECT_EQ(pick_loops(subject, 100).size(), 5U);
  EXPECT_TRUE(pick_loops(subject, 0).empty());
}

TEST(Page, DataCannotEndItsElementNorStandInForAnotherPart) {
  const std::string evil = "</script><script>alert(1)</script><!-- %SCRIPT% %STYLE% %NONCE%";
  const std::string html = page({{"title", evil}, {"name", evil}});
  EXPECT_THAT(html, AllOf(Not(HasSubstr("alert(1)</script>")), HasSubstr("\\u003c/script>"),
                          HasSubstr("&lt;/script&gt;"), Not(HasSubstr("connect-src"))));
  const auto begin = html.find("id=\"data\">") + 10;
  const auto data = nlohmann::json::parse(html.substr(begin, html.find("</script>", begin) - begin));
  EXPECT_EQ(data.at("name"), evil);
  // Bytes that are no text do no harm.
  EXPECT_THAT(page({{"name", "\xff\xfe"}}), HasSubstr("\xEF\xBF\xBD"));
}

TEST(Judge, NodesStandForTheirViewsAndOlderOnesAreAdmissible) {
  // Places 0 1 2 3 0 1: the last two are loops with nodes 0 and 1.
  const TopologicalMap map = sailmap::testing::map_of({0, 1, 2, 3, 0, 1});
  ASSERT_EQ(map.loops(), 2);
  Subject subject = subject_of(map, "fixed", {});
  // Image 5 is said to be at place 0 and not at 1: its loop is wrong, and there was something to be found.
  const Evaluation e = judge(subject, {{{}, {}, {}, {}, {0}, {0}}});
  EXPECT_EQ(e.fixed.detections, 2);
  EXPECT_EQ(e.fixed.right, 1);
  EXPECT_EQ(e.queries_with_match, 2);
  EXPECT_DOUBLE_EQ(e.fixed.recall, 0.5);
  EXPECT_EQ(subject.loops.at(0).right, true);
  EXPECT_EQ(subject.loops.at(1).right, false);
  EXPECT_THROW(judge(subject, {{{}, {}}}), Error);
  // exclude_recent is 2: image 3 cannot be compared with nodes 1 and 2.
  EXPECT_THROW(judge(subject, {{{}, {}, {}, {1, 2}, {}, {}}}), Error);
}

TEST(LayOut, EveryNodeHasAPlaceOfItsOwn) {
  std::vector<Edge> ring;
  for (int i = 0; i < 30; ++i) ring.push_back({i, (i + 1) % 30, EdgeKind::path});
  const std::vector<double> at = lay_out(30, ring);
  ASSERT_EQ(at.size(), 60U);
  std::set<std::pair<double, double>> places;
  for (std::size_t i = 0; i < at.size(); i += 2) places.emplace(at[i], at[i + 1]);
  EXPECT_EQ(places.size(), 30U);
  EXPECT_EQ(lay_out(1, {}).size(), 2U);
  EXPECT_TRUE(lay_out(0, {}).empty());
}

}  // namespace
}  // namespace sailmap::report
