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

std::string exported(std::string_view format) {
  std::ostringstream out;
  export_map(awkward_map(), format, out);
  return out.str();
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
  EXPECT_THAT(lines[5], ::testing::StartsWith(R"(4,"again",0,0,accepted,0,1e+06,1,)"));
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
    std::ostringstream out;
    EXPECT_NO_THROW(export_map(TopologicalMap{}, format, out)) << format;
  }
  EXPECT_THROW(exported("xls"), Error);
}

}  // namespace
}  // namespace sailmap
