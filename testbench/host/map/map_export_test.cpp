// Exports, read back by programs that are not ours.
#include "sailmap/map_export.hpp"

#include <gmock/gmock.h>
#include <graphviz/cgraph.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>

#include "host/map_builders.hpp"
#include "sailmap/error.hpp"

namespace sailmap {
namespace {

using ::testing::ElementsAre;

const TopologicalMap& awkward_map() {
  static const TopologicalMap map = [] {
    TopologicalMap m(testing::small_map_config());
    int place = 0;
    for (const char* image : {R"(a "quoted", name)", R"(back\slash)", "<&>", "plain"}) {
      m.add(image, testing::image_of_place(place++));
    }
    m.add("again", testing::image_of_place(0));
    return m;
  }();
  return map;
}

std::string exported(const TopologicalMap& map, std::string_view format, const ExportOptions& options = {}) {
  std::ostringstream out;
  export_map(map, format, out, options);
  return out.str();
}

std::string exported(std::string_view format) { return exported(awkward_map(), format); }

// Names as files may have them, and what is left of them as text.
struct OddName {
  const char* bytes;
  const char* text;
};
constexpr OddName odd_names[] = {{"line\nend", "line\nend"},
                                 {"caf\xe9", "caf\xEF\xBF\xBD"},  // Latin-1
                                 {"\xed\xa0\x80", nullptr},       // a surrogate, no character
                                 {"z\xc3\xbcrich \xf0\x9f\x97\xba", "z\xc3\xbcrich \xf0\x9f\x97\xba"},
                                 {"cut \xf0\x9f\x97", nullptr},
                                 {"ends with \\", "ends with \\"},
                                 {"&amp;", "&amp;"},
                                 {"]]>", "]]>"},
                                 {"", ""}};

const TopologicalMap& odd_map() {
  static const TopologicalMap map = [] {
    TopologicalMap m(testing::small_map_config());
    int place = 0;
    for (const OddName& name : odd_names) m.add(name.bytes, testing::image_of_place(place++));
    return m;
  }();
  return map;
}

TEST(MapExport, DotIsReadByGraphviz) {
  Agraph_t* graph = agmemread(exported("dot").c_str());
  ASSERT_NE(graph, nullptr);
  EXPECT_EQ(agnnodes(graph), 4);
  EXPECT_EQ(agnedges(graph), 4);
  Agnode_t* first = agnode(graph, const_cast<char*>("0"), 0);
  ASSERT_NE(first, nullptr);
  EXPECT_STREQ(agget(first, const_cast<char*>("tooltip")), R"(a "quoted", name)");
  agclose(graph);
}

TEST(MapExport, GraphmlHoldsNamesAndKinds) {
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(exported("graphml").c_str()));
  const pugi::xml_node graph = document.child("graphml").child("graph");
  std::vector<std::string> names;
  for (const pugi::xml_node node : graph.children("node"))
    names.emplace_back(node.find_child_by_attribute("data", "key", "name").text().get());
  EXPECT_THAT(names, ElementsAre(R"(a "quoted", name)", R"(back\slash)", "<&>", "plain"));
  std::vector<std::string> kinds;
  for (const pugi::xml_node edge : graph.children("edge"))
    kinds.emplace_back(edge.child("data").text().get());
  EXPECT_THAT(kinds, ElementsAre("path", "path", "path", "loop"));
}

TEST(MapExport, OddNamesAreTextInGraphml) {
  pugi::xml_document document;
  const std::string xml = exported(odd_map(), "graphml");
  ASSERT_TRUE(document.load_string(xml.c_str(), pugi::parse_default | pugi::parse_ws_pcdata));
  std::size_t i = 0;
  for (const pugi::xml_node node : document.child("graphml").child("graph").children("node")) {
    const std::string name = node.find_child_by_attribute("data", "key", "name").text().get();
    const OddName& expected = odd_names[i++];
    if (expected.text != nullptr) {
      EXPECT_EQ(name, expected.text);
    } else {
      EXPECT_THAT(name, ::testing::HasSubstr("\xEF\xBF\xBD")) << expected.bytes;
    }
  }
  EXPECT_EQ(i, std::size(odd_names));
}

TEST(MapExport, OddNamesAreOneStringInDot) {
  Agraph_t* graph = agmemread(exported(odd_map(), "dot").c_str());
  ASSERT_NE(graph, nullptr);
  EXPECT_EQ(agnnodes(graph), static_cast<int>(std::size(odd_names)));
  const auto tooltip = [graph](const char* id) {
    return std::string(agget(agnode(graph, const_cast<char*>(id), 0), const_cast<char*>("tooltip")));
  };
  EXPECT_EQ(tooltip("0"), "line\nend");
  EXPECT_EQ(tooltip("5"), R"(ends with \\)");  // graphviz itself halves them where it shows them
  EXPECT_EQ(tooltip("6"), "&amp;amp;");
  agclose(graph);
}

TEST(MapExport, JsonOfOddNamesIsUtf8) {
  const auto json = nlohmann::json::parse(exported(odd_map(), "json"));
  EXPECT_EQ(json.at("images").at(0).at("name"), "line\nend");
  EXPECT_EQ(json.at("images").at(1).at("name"), "caf\xEF\xBF\xBD");
}

TEST(MapExport, G2oHasAVertexANodeAndAnEdgeAnEdge) {
  std::istringstream in(exported("g2o"));
  std::string line;
  int vertices = 0;
  std::vector<std::array<double, 5>> edges;
  while (std::getline(in, line)) {
    std::istringstream fields(line);
    std::string kind;
    fields >> kind;
    if (kind == "VERTEX_SE2") {
      ++vertices;
      continue;
    }
    ASSERT_EQ(kind, "EDGE_SE2");
    std::array<double, 5> head{};
    for (double& v : head) fields >> v;
    std::array<double, 6> information{};
    for (double& v : information) fields >> v;
    EXPECT_TRUE(fields) << line;
    edges.push_back(head);
  }
  EXPECT_EQ(vertices, 4);
  EXPECT_THAT(edges, ElementsAre(std::array{0.0, 1.0, 1.0, 0.0, 0.0}, std::array{1.0, 2.0, 1.0, 0.0, 0.0},
                                 std::array{2.0, 3.0, 1.0, 0.0, 0.0}, std::array{3.0, 0.0, 0.0, 0.0, 0.0}));
}

TEST(MapExport, CsvHasALineAnImageWithQuotedNames) {
  std::istringstream in(exported("csv"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(lines[1], R"(0,"a ""quoted"", name",0,1,no_nodes,,,,,0)");
  EXPECT_THAT(lines[5], ::testing::StartsWith(R"(4,"again",0,0,accepted,0,1000000,1,)"));
}

TEST(MapExport, JsonHoldsEverything) {
  const auto json = nlohmann::json::parse(exported("json"));
  EXPECT_EQ(json.at("nodes").size(), 4U);
  EXPECT_EQ(json.at("edges").size(), 4U);
  EXPECT_EQ(json.at("images").size(), 5U);
  EXPECT_EQ(json.at("images").at(4).at("detection").at("reason"), "accepted");
  EXPECT_EQ(json.at("nodes").at(2).at("views").at(0).at("name"), "<&>");
}

TEST(MapExport, AnEmptyMapIsStillValid) {
  for (const std::string_view format : export_formats()) {
    EXPECT_NO_THROW(exported(TopologicalMap{}, format)) << format;
  }
  EXPECT_THROW(exported("xls"), Error);
}

TEST(MapExport, TrajectoriesNeedPoses) {
  ExportOptions options;
  EXPECT_THROW(exported(awkward_map(), "tum", options), Error);
  EXPECT_THROW(exported(awkward_map(), "kitti", options), Error);
  options.poses.resize(4);
  EXPECT_THROW(exported(awkward_map(), "kitti", options), Error);  // of five images
  options.poses.resize(5);
  EXPECT_NO_THROW(exported(awkward_map(), "kitti", options));
  EXPECT_THROW(exported(awkward_map(), "tum", options), Error);  // no times
}

TEST(MapExport, AtNodesARecognisedImageIsWhereItsNodeIs) {
  ExportOptions options;
  for (int i = 0; i < 5; ++i) options.poses.push_back({cv::Affine3d().translate({1.0 * i, 0, 0}), 10.0 + i});
  EXPECT_THAT(exported(awkward_map(), "tum", options), ::testing::EndsWith("\n14 4 0 0 0 0 0 1\n"));
  options.at_nodes = true;
  EXPECT_THAT(exported(awkward_map(), "tum", options), ::testing::EndsWith("\n14 0 0 0 0 0 0 1\n"));
  EXPECT_THAT(exported(awkward_map(), "kitti", options),
              ::testing::EndsWith("\n1 0 0 3 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 0\n"));
}

// The last image is recognised at node 0, and the way there was the step before it: the loop edge has that.
TEST(MapExport, G2oEdgesHaveTheMotionOfTheImagesThatMadeThem) {
  ExportOptions options;
  for (const double x : {0.0, 1.0, 3.0, 6.0, 0.5}) {
    options.poses.push_back({cv::Affine3d().translate({x, 0, 0})});
  }
  std::istringstream in(exported(awkward_map(), "g2o", options));
  std::vector<std::string> edges;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("EDGE")) edges.push_back(line.substr(0, line.find(" 0 0 0 0 0 1 ")));
  }
  EXPECT_THAT(edges, ElementsAre("EDGE_SE3:QUAT 0 1 1", "EDGE_SE3:QUAT 1 2 2", "EDGE_SE3:QUAT 2 3 3",
                                 "EDGE_SE3:QUAT 3 0 -5.5"));
}

}  // namespace
}  // namespace sailmap
