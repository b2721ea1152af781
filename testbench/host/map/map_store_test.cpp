// Map files: what is saved comes back, and what is wrong is told.
#include "sailmap/map_store.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "host/map_builders.hpp"
#include "sailmap/error.hpp"

namespace sailmap {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class MapStoreTest : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::string text() const {
    std::ifstream in(path_);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void write(const std::string& text) const { std::ofstream(path_) << text; }
  std::string fault() const {
    try {
      open_map_store(path_)->load();
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_ = fs::temp_directory_path() / ("sailmap-store-" + std::to_string(::getpid()));
  fs::path path_ = folder_ / "map.json";
};

TEST_F(MapStoreTest, WhatIsSavedComesBack) {
  MapConfig config = testing::small_map_config();
  config.sparse = true;
  config.regions.inhibition = Inhibition::gaussian;
  config.regions.descriptor = DescriptorKind::background;
  config.match.method = Method::paper;
  config.detection.threshold = 12.5;
  const TopologicalMap map = testing::map_of({0, 1, 1, 2, 3, 0, 4}, config);
  const auto store = open_map_store(path_);
  EXPECT_FALSE(store->exists());
  store->save(map, "reference");
  EXPECT_TRUE(store->exists());
  const StoredMap loaded = store->load();
  EXPECT_EQ(loaded.frontend, "reference");
  const TopologicalMap& back = loaded.map;
  EXPECT_EQ(back.edges(), map.edges());
  EXPECT_EQ(back.active(), map.active());
  EXPECT_EQ(back.config().regions.inhibition, Inhibition::gaussian);
  EXPECT_EQ(back.config().regions.descriptor, DescriptorKind::background);
  EXPECT_EQ(back.config().match.method, Method::paper);
  EXPECT_EQ(back.config().detection.threshold, 12.5);
  EXPECT_EQ(back.config().exclude_recent, 2);
  EXPECT_TRUE(back.config().sparse);
  ASSERT_EQ(back.nodes().size(), map.nodes().size());
  for (std::size_t i = 0; i < map.nodes().size(); ++i) {
    ASSERT_EQ(back.nodes()[i].views.size(), map.nodes()[i].views.size());
    for (std::size_t k = 0; k < map.nodes()[i].views.size(); ++k) {
      EXPECT_EQ(back.nodes()[i].views[k].name, map.nodes()[i].views[k].name);
      EXPECT_EQ(back.nodes()[i].views[k].signature, map.nodes()[i].views[k].signature);
    }
  }
  ASSERT_EQ(back.images(), map.images());
  EXPECT_EQ(back.loops(), map.loops());
  EXPECT_EQ(back.history()[5].detection.matches, map.history()[5].detection.matches);
}

TEST_F(MapStoreTest, AMapGoesOnAfterLoadingAsIfItHadNeverStopped) {
  const auto store = open_map_store(path_);
  store->save(testing::map_of({0, 1, 2, 3}), "reference");
  TopologicalMap loaded = store->load().map;
  loaded.add("image4", testing::image_of_place(1));
  EXPECT_EQ(loaded.edges(), testing::map_of({0, 1, 2, 3, 1}).edges());
}

TEST_F(MapStoreTest, DamagedFilesAreNamedAndNotLoaded) {
  open_map_store(path_)->save(testing::map_of({0, 1, 2}), "reference");
  const std::string good = text();
  for (const std::size_t length : {std::size_t{0}, good.size() / 3, good.size() - 3}) {
    write(good.substr(0, length));
    EXPECT_THAT(fault(), HasSubstr("map.json: not a sailmap map, or a damaged one")) << length;
    EXPECT_EQ(fault().find('\n'), std::string::npos);
  }
  write(R"({"format": "something", "version": 1})");
  EXPECT_THAT(fault(), HasSubstr("not a sailmap map"));
  auto json = nlohmann::ordered_json::parse(good);
  json["version"] = 99;
  write(json.dump());
  EXPECT_THAT(fault(), HasSubstr("map format version 99"));
  json = nlohmann::ordered_json::parse(good);
  json["map"]["edges"][0]["to"] = 17;
  write(json.dump());
  EXPECT_THAT(fault(), HasSubstr("map contradicts itself: edge 0-17 leads to no node"));
  json = nlohmann::ordered_json::parse(good);
  json["map"]["nodes"][0]["views"][0]["signature"]["regions"][0]["descriptor"].erase(0);
  write(json.dump());
  EXPECT_THAT(fault(), HasSubstr("a descriptor has not ten numbers"));
}

// A change to a good file, and what is said of it.
struct Damage {
  const char* at;  // JSON pointer
  nlohmann::ordered_json value;
  const char* fault;
};

TEST_F(MapStoreTest, NumbersThatMeanNothingAreRefused) {
  open_map_store(path_)->save(testing::map_of({0, 1, 2, 3, 0}), "reference");
  const auto good = nlohmann::ordered_json::parse(text());
  const Damage damages[] = {
      {"/map/active", 4294967296, "a whole number expected, not 4294967296"},
      {"/map/active", -2147483649, "a whole number expected"},
      {"/map/active", 1e300, "a whole number expected, not 1e+300"},
      {"/map/active", 0.5, "a whole number expected, not 0.5"},
      {"/map/active", true, "a whole number expected, not boolean"},
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
    json.at(nlohmann::ordered_json::json_pointer(damage.at)) = damage.value;
    write(json.dump());
    EXPECT_THAT(fault(), HasSubstr(damage.fault)) << damage.at;
    EXPECT_THAT(fault(), ::testing::StartsWith(path_.string() + ": ")) << damage.at;
  }
}

TEST_F(MapStoreTest, AnyDepthOfBracketsIsRefused) {
  const std::string deep = std::string(200000, '[') + std::string(200000, ']');
  write(R"({"format": "sailmap map", "version": )" + deep + "}");
  EXPECT_THAT(fault(), HasSubstr("a whole number expected, not array"));
}

TEST_F(MapStoreTest, APathThatNoFileCanHaveDoesNotExist) {
  const auto store = open_map_store(folder_ / std::string(300, 'x'));
  EXPECT_FALSE(store->exists());
  EXPECT_THROW((void)store->load(), Error);
}

TEST_F(MapStoreTest, AFolderThatCannotBeWrittenLeavesNothing) {
  const fs::path missing = folder_ / "missing" / "map.json";
  EXPECT_THROW(open_map_store(missing)->save(testing::map_of({0}), "reference"), Error);
  EXPECT_FALSE(fs::exists(missing.parent_path()));
  EXPECT_THROW(open_map_store(folder_)->load(), Error);
}

}  // namespace
}  // namespace sailmap
