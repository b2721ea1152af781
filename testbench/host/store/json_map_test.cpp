// Map files of version 1, JSON: they are read, carried over when written to, and what is wrong with one is
// told.
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "host/map_builders.hpp"
#include "map/map_json.hpp"
#include "sailmap/error.hpp"
#include "sailmap/map_store.hpp"
#include "temporary_folder.hpp"

namespace sailmap {
namespace {

using nlohmann::ordered_json;
using ::testing::HasSubstr;

ordered_json document(const TopologicalMap& map) {
  return {{"format", "sailmap map"}, {"version", 1}, {"frontend", "reference"}, {"map", to_json(map)}};
}

class JsonMapTest : public ::testing::Test {
 protected:
  void write(const std::string& text) const { std::ofstream(path_) << text; }
  std::string fault() const {
    try {
      static_cast<void>(MapStore(path_).load());
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  testing::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "map.json";
};

TEST_F(JsonMapTest, IsLoaded) {
  const TopologicalMap map = testing::map_of({0, 1, 1, 2, 3, 0, 4});
  write(document(map).dump());
  const StoredMap loaded = MapStore(path_).load();
  EXPECT_EQ(loaded.frontend, "reference");
  EXPECT_EQ(to_json(loaded.map), to_json(map));
}

TEST_F(JsonMapTest, BecomesADatabaseWhenItIsWrittenTo) {
  const TopologicalMap map = testing::map_of({0, 1, 2, 3});
  write(document(map).dump());
  {
    MapWriter writer(path_);
    EXPECT_EQ(to_json(writer.load()->map), to_json(map));
  }
  std::string head(15, ' ');
  std::ifstream(path_).read(head.data(), 15);
  EXPECT_EQ(head, "SQLite format 3");
  EXPECT_EQ(to_json(MapStore(path_).load().map), to_json(map));
}

TEST_F(JsonMapTest, StaysAsItIsWhenItIsDamagedAndShouldBeWrittenTo) {
  write("{\"format\": \"sailmap map\", \"version\"");
  EXPECT_THROW(MapWriter writer(path_), Error);
  EXPECT_EQ(std::filesystem::file_size(path_), 35U);
}

TEST_F(JsonMapTest, DamagedFilesAreNamedAndNotLoaded) {
  const ordered_json good = document(testing::map_of({0, 1, 2}));
  const std::string text = good.dump();
  for (const std::size_t length : {std::size_t{0}, text.size() / 3, text.size() - 3}) {
    write(text.substr(0, length));
    EXPECT_THAT(fault(), HasSubstr("map.json: not a sailmap map, or a damaged one")) << length;
    EXPECT_EQ(fault().find('\n'), std::string::npos);
  }
  write(R"({"format": "something", "version": 1})");
  EXPECT_THAT(fault(), HasSubstr("not a sailmap map"));
  auto json = good;
  json["version"] = 99;
  write(json.dump());
  EXPECT_THAT(fault(), HasSubstr("map format version 99"));
  json = good;
  json["map"]["edges"][0]["to"] = 17;
  write(json.dump());
  EXPECT_THAT(fault(), HasSubstr("map contradicts itself: edge 0-17 leads to no node"));
  json = good;
  json["map"]["nodes"][0]["views"][0]["signature"]["regions"][0]["descriptor"].erase(0);
  write(json.dump());
  EXPECT_THAT(fault(), HasSubstr("a descriptor has not ten numbers"));
}

// A change to a good file, and what is said of it.
struct Damage {
  const char* at;  // JSON pointer
  ordered_json value;
  const char* fault;
};

TEST_F(JsonMapTest, NumbersThatMeanNothingAreRefused) {
  const ordered_json good = document(testing::map_of({0, 1, 2, 3, 0}));
  const Damage damages[] = {
      {"/map/active", 4294967296, "a whole number expected, not 4294967296"},
      {"/map/active", -2147483649, "a whole number expected"},
      {"/map/active", 1e300, "a whole number expected, not 1e+300"},
      {"/map/active", 0.5, "a whole number expected, not 0.5"},
      {"/map/active", true, "a whole number expected, not boolean"},
      {"/map/active", 2, "the active node is not the last image's"},
      {"/map/nodes/0/views/0/signature/width", -300, "an image without pixels"},
      {"/map/nodes/0/views/0/signature/regions/0/x", 300, "not a pixel of the image: 300"},
      {"/map/nodes/0/views/0/signature/regions/0/y", -1, "not a pixel of the image: -1"},
      {"/map/nodes/0/views/0/signature/regions/0/saliency", 1e39, "a number is out of range: 1e+39"},
      {"/map/images/4/image", 3, "image 4 is numbered 3"},
      {"/map/images/4/node", 9, "image 4 belongs to no node"},
      {"/map/images/4/detection/best/node", 9, "image 4 was compared with no node"},
      {"/map/images/4/detection/best/node", -3, "image 4 was compared with no node"},
      {"/map/images/4/detection/matches/0/query", -1, "image 4 has a matched region that is none"},
      {"/map/edges/0/kind", "a\nb", "no edge kind 'a?b'"},
  };
  for (const Damage& damage : damages) {
    auto json = good;
    json.at(ordered_json::json_pointer(damage.at)) = damage.value;
    write(json.dump());
    EXPECT_THAT(fault(), HasSubstr(damage.fault)) << damage.at;
    EXPECT_THAT(fault(), ::testing::StartsWith(path_.string() + ": ")) << damage.at;
  }
}

TEST_F(JsonMapTest, AnyDepthOfBracketsIsRefused) {
  const std::string deep = std::string(200000, '[') + std::string(200000, ']');
  write(R"({"format": "sailmap map", "version": )" + deep + "}");
  EXPECT_THAT(fault(), HasSubstr("a whole number expected, not array"));
}

}  // namespace
}  // namespace sailmap
