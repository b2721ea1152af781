// The map plot, read back: nodes, edges, colours, words.
#include <gmock/gmock.h>

#include <map>
#include <set>
#include <thread>

#include "figure_fixture.hpp"
#include "host/map_builders.hpp"
#include "sailmap/error.hpp"
#include "sailmap/figures.hpp"

namespace sailmap {
namespace {

namespace fs = std::filesystem;
using testing::all_text;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// `nodes` in a row, loops between some of them with the similarity of the detections that made them.
struct Loop {
  int from, to;
  double similarity;
};
TopologicalMap row_with_loops(int nodes, const std::vector<Loop>& loops) {
  MapConfig config;
  config.detection.threshold = 20;
  std::vector<Node> made;
  std::vector<Edge> edges;
  std::vector<Update> history;
  const auto view = [](int image) { return View{image, "image" + std::to_string(image), {640, 480, {}}}; };
  for (int i = 0; i < nodes; ++i) {
    made.push_back({i, {view(i)}});
    if (i > 0) edges.push_back({i - 1, i, EdgeKind::path});
    history.push_back({i, "image" + std::to_string(i), i, true, {}});
  }
  // Each loop: the robot is at `from`, and then sees `to`.
  for (const Loop& loop : loops) {
    const int image = static_cast<int>(history.size());
    history.push_back({image, "at", loop.from, false, {}});
    Detection detection;
    detection.reason = Reason::accepted;
    detection.best = {loop.to, loop.similarity};
    history.push_back({image + 1, "loop", loop.to, false, detection});
    edges.push_back({loop.from, loop.to, EdgeKind::loop});
  }
  const int active = history.empty() ? -1 : history.back().node;
  return {config, made, edges, history, active};
}

class MapPlotTest : public testing::FigureTest {
 protected:
  pugi::xml_document plotted(const TopologicalMap& map, const std::string& title = "map") {
    write_map_plot(folder_ / "map.svg", map, title);
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_file((folder_ / "map.svg").c_str());
    EXPECT_TRUE(parsed) << parsed.description();
    EXPECT_EQ(files(), 1);
    return document;
  }
};

// The stroke of each edge by its name, "3--7".
std::map<std::string, std::string> strokes(const pugi::xml_document& document) {
  std::map<std::string, std::string> out;
  for (const auto& edge : document.select_nodes("//g[@class='edge']")) {
    out[edge.node().child_value("title")] =
        edge.node().select_node(".//path").node().attribute("stroke").value();
  }
  return out;
}

// Red, green and blue of "#rrggbb".
cv::Vec3d rgb(const std::string& colour) {
  EXPECT_THAT(colour, ::testing::MatchesRegex("#[0-9a-f]{6}"));
  cv::Vec3d out;
  for (int i = 0; i < 3; ++i)
    out[i] = std::stoi(colour.substr(1 + 2 * static_cast<std::size_t>(i), 2), nullptr, 16);
  return out;
}

TEST_F(MapPlotTest, HasANodeAndAnEdgeForEach) {
  const TopologicalMap map = testing::map_of({0, 1, 2, 3, 1, 4});
  ASSERT_EQ(map.loops(), 1);
  const pugi::xml_document document = plotted(map);
  std::set<std::string> names;
  for (const auto& node : document.select_nodes("//g[@class='node']"))
    names.insert(node.node().child_value("title"));
  EXPECT_THAT(names, ::testing::ElementsAre("0", "1", "2", "3", "4"));
  const auto edges = strokes(document);
  ASSERT_EQ(edges.size(), map.edges().size());
  for (const Edge& edge : map.edges()) {
    const auto found = edges.find(std::to_string(edge.from) + "--" + std::to_string(edge.to));
    ASSERT_NE(found, edges.end());
    EXPECT_EQ(found->second == "#9a9a9a", edge.kind == EdgeKind::path);
  }
  EXPECT_THAT(all_text(document),
              AllOf(HasSubstr("6 images, 5 nodes, 1 loop closure\n"), HasSubstr("\n3\n")));
}

TEST_F(MapPlotTest, LoopsAreColouredByTheSimilarityOfTheirDetection) {
  const TopologicalMap map = row_with_loops(12, {{8, 0, 20}, {9, 1, 50}, {10, 2, 80}, {11, 3, 1e6}});
  const pugi::xml_document document = plotted(map);
  const auto edges = strokes(document);
  const cv::Vec3d weak = rgb(edges.at("8--0"));
  const cv::Vec3d middle = rgb(edges.at("9--1"));
  const cv::Vec3d strong = rgb(edges.at("10--2"));
  // Orange to dark red: at the threshold light, half-way up the scale half-way, the same from its end on.
  EXPECT_GT(weak[1], 150);
  EXPECT_LT(strong[1], 10);
  EXPECT_NEAR(middle[1], (weak[1] + strong[1]) / 2.0, 1);
  EXPECT_NEAR(middle[0], (weak[0] + strong[0]) / 2.0, 1);
  EXPECT_EQ(edges.at("11--3"), edges.at("10--2"));
  EXPECT_THAT(all_text(document), AllOf(HasSubstr("20"), HasSubstr("80 and above")));
  EXPECT_THAT(contents(folder_ / "map.svg"), HasSubstr("similarity 50"));
}

// Centres of the nodes' circles.
std::vector<cv::Point2d> centres(const pugi::xml_document& document) {
  std::vector<cv::Point2d> out;
  for (const auto& found : document.select_nodes("//g[@class='node']//ellipse")) {
    out.emplace_back(found.node().attribute("cx").as_double(), found.node().attribute("cy").as_double());
  }
  return out;
}

TEST_F(MapPlotTest, MapsOfAnySizeFillOnePage) {
  for (const int nodes : {3, 60, 250, 900}) {
    const TopologicalMap map = row_with_loops(nodes, {{nodes - 1, 0, 30}});
    const pugi::xml_document document = plotted(map);
    const auto places = centres(document);
    ASSERT_EQ(static_cast<int>(places.size()), nodes);
    const auto across =
        std::minmax_element(places.begin(), places.end(), [](auto a, auto b) { return a.x < b.x; });
    const auto down =
        std::minmax_element(places.begin(), places.end(), [](auto a, auto b) { return a.y < b.y; });
    const double width = across.second->x - across.first->x;
    const double height = down.second->y - down.first->y;
    EXPECT_LE(width, 861);
    EXPECT_LE(height, 561);
    EXPECT_TRUE(width > 859 || height > 559) << nodes;
    // Numbers inside the nodes of small maps; beside some nodes of large ones.
    std::istringstream lines(all_text(document));
    std::set<int> numbers;
    for (std::string line; std::getline(lines, line);) {
      if (!line.empty() && line.find_first_not_of("0123456789") == std::string::npos)
        numbers.insert(std::stoi(line));
    }
    if (nodes <= 60) {
      for (int i = 0; i < nodes; ++i) EXPECT_TRUE(numbers.contains(i)) << i;
    } else {
      EXPECT_LE(numbers.size(), 41U);
      EXPECT_GE(numbers.size(), 10U);
      EXPECT_TRUE(numbers.contains(nodes == 250 ? 240 : 850));
    }
  }
}

TEST_F(MapPlotTest, NeighboursOnAPathLieNearEachOther) {
  const TopologicalMap map = row_with_loops(30, {});
  const auto places = centres(plotted(map));
  const double all = cv::norm(places.front() - places.back());
  for (std::size_t i = 1; i < places.size(); ++i) EXPECT_LT(cv::norm(places[i] - places[i - 1]), all / 10);
}

TEST_F(MapPlotTest, TheSameMapIsTheSamePlotFromAnyThread) {
  const TopologicalMap map = row_with_loops(40, {{39, 0, 30}, {25, 5, 60}});
  const auto draw = [&](int k) { write_map_plot(folder_ / (std::to_string(k) + ".svg"), map, "m"); };
  std::vector<std::thread> threads;
  threads.reserve(4);
  for (int k = 0; k < 4; ++k) threads.emplace_back(draw, k);
  for (std::thread& thread : threads) thread.join();
  draw(4);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(contents(folder_ / (std::to_string(k) + ".svg")), contents(folder_ / "4.svg"));
  }
}

TEST_F(MapPlotTest, EmptyAndSmallestMapsAndStrangeWords) {
  EXPECT_THAT(all_text(plotted(TopologicalMap{}, "")), HasSubstr("0 images, 0 nodes, 0 loop closures"));
  EXPECT_EQ(centres(plotted(row_with_loops(1, {}))).size(), 1U);
  TopologicalMap named;
  named.add("<b>\"odd\" &\xFF\ncaf\xC3\xA9.png", {640, 480, {}});
  const pugi::xml_document document = plotted(named, "<TABLE> & 'title' \"x\" \\N caf\xC3\xA9");
  EXPECT_THAT(all_text(document), HasSubstr("<TABLE> & 'title' \"x\" \\N caf\xC3\xA9"));
  const std::string tip = document.select_node("//g[@class='node']//a/@xlink:title").attribute().value();
  EXPECT_THAT(tip, HasSubstr("<b>\"odd\" & caf\xC3\xA9.png"));
}

TEST_F(MapPlotTest, StrictMapsHaveNoLoopEdges) {
  MapConfig config = testing::small_map_config();
  config.loop_edges = false;
  const TopologicalMap map = testing::map_of({0, 1, 2, 3, 1, 4}, config);
  ASSERT_EQ(map.loops(), 1);
  for (const auto& [name, stroke] : strokes(plotted(map))) EXPECT_EQ(stroke, "#9a9a9a") << name;
}

TEST_F(MapPlotTest, NothingIsLeftWhenItCannotBeWritten) {
  const fs::path nowhere = folder_ / "missing" / "map.svg";
  EXPECT_THAT(
      [&] {
        write_map_plot(nowhere, testing::map_of({0, 1}), "t");
      },
      ThrowsMessage<Error>(HasSubstr(nowhere.string())));
  EXPECT_EQ(files(), 0);
}

}  // namespace
}  // namespace sailmap
